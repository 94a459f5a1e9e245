# Cross-compiles with Debian's MinGW-w64 (posix threads) for 64-bit Windows. FEEDSCOPE_WINDOWS_PREFIX, in the environment:
# where packaging/windows/build installs the libraries.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(target x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${target}-gcc-posix)
set(CMAKE_CXX_COMPILER ${target}-g++-posix)
set(CMAKE_RC_COMPILER ${target}-windres)
set(CMAKE_FIND_ROOT_PATH $ENV{FEEDSCOPE_WINDOWS_PREFIX} /usr/${target})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Windows 10 is the oldest system of Qt 6.
add_compile_definitions(_WIN32_WINNT=0x0A00 WINVER=0x0A00)
# Headers that expect a DLL otherwise.
add_compile_definitions(CMARK_STATIC_DEFINE XML_STATIC)
# The compiler's own libraries become part of each program and DLL.
foreach(kind EXE SHARED MODULE)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT -static)
endforeach()
