# What every target is compiled with: C++20, warnings, sanitizers; the presets also use ccache and mold.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(FEEDSCOPE_FAST_TOOLS "Compile with ccache and link with mold where they are installed" OFF)
if(FEEDSCOPE_FAST_TOOLS)
  find_program(CCACHE ccache)
  find_program(MOLD mold)
endif()
# Without CCACHE_DEPEND a precompiled header is found again although a comment in it changed: preprocessed they are equal.
# GCC then does not know the changed file for the one of the precompiled header, and reads it twice.
if(FEEDSCOPE_FAST_TOOLS AND CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()
if(FEEDSCOPE_FAST_TOOLS AND MOLD AND NOT WIN32)
  add_link_options(-fuse-ld=mold)
endif()

add_library(feedscope_settings INTERFACE)
target_include_directories(feedscope_settings INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(feedscope_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>
  $<$<NOT:$<BOOL:${FEEDSCOPE_UNITY}>>:-Wshadow> # together, sources would shadow names of each other
  $<$<BOOL:${FEEDSCOPE_WARNINGS_AS_ERRORS}>:-Werror>)
# The compiler collects its garbage from 600 MB on only: a seventh less of its time, a fifth to a third more of its memory.
add_compile_options("$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=300;--param=ggc-min-heapsize=600000>")
# Of "text" + std::string, where there is nothing: GCC bug 105651.
target_compile_options(feedscope_settings INTERFACE
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>")
if(FEEDSCOPE_SANITIZE)
  add_compile_options(-fsanitize=${FEEDSCOPE_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${FEEDSCOPE_SANITIZE})
  # Of std::regex and std::function, where there is nothing: GCC bug 105562.
  target_compile_options(feedscope_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# From here on in this folder, Clang compiles and links if it is there, in place of GCC: sources that are not optimised
# take it half to two thirds of the time. CMake knows one compiler a language; what it writes from these variables is of the
# folder that they are set in.
macro(feedscope_compile_with_clang)
  find_program(CLANG clang++)
  if(CLANG AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(CMAKE_CXX_COMPILER ${CLANG})
    set(CMAKE_CXX_COMPILER_ID Clang)
    execute_process(COMMAND ${CLANG} -dumpversion OUTPUT_VARIABLE CMAKE_CXX_COMPILER_VERSION OUTPUT_STRIP_TRAILING_WHITESPACE)
    include(Compiler/Clang)
    __compiler_clang(CXX)
    unset(CMAKE_CXX_COMPILE_OPTIONS_INVALID_PCH)
  endif()
endmacro()
