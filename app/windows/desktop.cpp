#include "app/desktop.h"

#include <windows.h>

namespace feedscope {

void check_display(const char*) {}  // Windows has one always

void close_own_console() {
  DWORD process = 0;
  if (GetConsoleProcessList(&process, 1) == 1) {
    FreeConsole();
  }
}

}  // namespace feedscope
