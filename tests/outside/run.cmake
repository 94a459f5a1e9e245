# Installs the library to an empty folder, builds resources/examples/library on it, and compares what the example prints
# with what the program says.
set(work ${BUILD}/tests/outside/work)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${code}\n${out}\n${err}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component development --prefix ${work}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE}/resources/examples/library -B ${work}/build -DCMAKE_PREFIX_PATH=${work}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${work}/build)
set(part ${SOURCE}/resources/programs/essid_spline.nc)
run(${work}/build/cycle_time ${part} spinner-mvc850)
set(example "${output}")
run(${PROGRAM} simulate ${part} --machine spinner-mvc850 --json -)
string(JSON seconds GET "${output}" cycle_time_s)
string(REGEX MATCH ": ([0-9.]+) s" found "${example}")
set(printed ${CMAKE_MATCH_1})
# Both to a millisecond: the example rounds.
string(REGEX REPLACE "^([0-9]+)\\.([0-9][0-9][0-9]).*" "\\1\\2" whole "${seconds}")
string(REPLACE "." "" rounded "${printed}")
math(EXPR difference "${rounded} - ${whole}")
if(NOT (difference EQUAL 0 OR difference EQUAL 1))
  message(FATAL_ERROR "the example says ${printed} s, feedscope ${seconds} s")
endif()
if(NOT example MATCHES "% programmed feed")
  message(FATAL_ERROR "no limiting cause in:\n${example}")
endif()
