#include "app/desktop.h"

#include <fmt/format.h>

#include <cstdlib>

#include "core/base/error.h"

namespace feedscope {

void check_display(const char* instead) {
  const auto set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (!set("DISPLAY") && !set("WAYLAND_DISPLAY") && !set("QT_QPA_PLATFORM")) {
    throw InputError(fmt::format(
        "the window needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; {}", instead));
  }
}

void close_own_console() {}

}  // namespace feedscope
