# The Windows program: recursion and large programs get the stack that threads have on Linux.
target_link_options(feedscope PRIVATE -Wl,--stack,8388608)

# Icon, version and the code page UTF-8, in which libraries open files.
enable_language(RC)
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
find_program(ICOTOOL icotool REQUIRED)
foreach(size IN ITEMS 16 24 32 48 64 256)
  set(icon ${CMAKE_CURRENT_BINARY_DIR}/feedscope-${size}.png)
  add_custom_command(OUTPUT ${icon}
    COMMAND ${RSVG_CONVERT} -w ${size} -h ${size} -o ${icon} ${PROJECT_SOURCE_DIR}/resources/icons/feedscope.svg
    DEPENDS ${PROJECT_SOURCE_DIR}/resources/icons/feedscope.svg)
  if(size EQUAL 256)
    list(APPEND icon_words -r)  # as PNG, which is small
  endif()
  list(APPEND icons ${icon})
  list(APPEND icon_words ${icon})
endforeach()
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/feedscope.ico
  COMMAND ${ICOTOOL} -c -o ${CMAKE_CURRENT_BINARY_DIR}/feedscope.ico ${icon_words}
  DEPENDS ${icons})
add_custom_target(windows_icon DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/feedscope.ico)
add_dependencies(feedscope windows_icon)
configure_file(packaging/windows/feedscope.rc.in feedscope.rc @ONLY)
target_sources(feedscope PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/feedscope.rc)
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/feedscope.rc TARGET_DIRECTORY feedscope
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON OBJECT_DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/feedscope.ico)
