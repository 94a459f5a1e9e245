#include "ui/scene/offscreen/posix/shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <locale.h>
#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace feedscope::ui {
namespace {

/// Reason of the latest dlopen() failure; in English in every locale, because its words are compared.
std::string latest_reason() {
  const locale_t english = newlocale(LC_ALL_MASK, "C", nullptr);
  const locale_t before = uselocale(english);
  const char* text = dlerror();
  std::string reason = text != nullptr ? text : "";
  uselocale(before);
  freelocale(english);
  return reason;
}

bool is_missing(const std::string& reason, std::string_view name) {
  return reason.starts_with(name) && reason.ends_with("No such file or directory");
}

/// glibc does not add "Cannot allocate memory" if a library does not fit into the address space.
bool is_lack_of_memory(std::string_view reason) {
  constexpr std::array endings{"failed to map segment from shared object", "cannot map zero-fill pages",
                               "Cannot allocate memory", "out of memory"};
  return std::ranges::any_of(endings, [&](const char* ending) { return reason.ends_with(ending); });
}

}  // namespace

// Linux and macOS; Windows would need LoadLibrary and GetProcAddress (untested).
SharedLibrary::SharedLibrary(std::initializer_list<const char*> names) {
  std::string message;
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      return;
    }
    const std::string reason = latest_reason();
    if (is_lack_of_memory(reason)) {
      throw std::bad_alloc();
    }
    if (message.empty() && !is_missing(reason, name)) {
      message = fmt::format("{} cannot be loaded ({})", name, reason);
    }
  }
  throw InputError(message.empty() ? std::string(*names.begin()) + " is not installed" : message);
}

void* SharedLibrary::address(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) {
    throw InputError(std::string("the OpenGL library lacks ") + name);
  }
  return found;
}

}  // namespace feedscope::ui
