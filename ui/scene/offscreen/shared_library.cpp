#include "ui/scene/offscreen/shared_library.h"

#include <dlfcn.h>

#include <string>

#include "core/base/error.h"

namespace feedscope::ui {

// Linux and macOS; on Windows LoadLibrary and GetProcAddress take these places (untested).
SharedLibrary::SharedLibrary(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      return;
    }
  }
  throw InputError(std::string(*names.begin()) + " is not installed");
}

void* SharedLibrary::address(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) {
    throw InputError(std::string("the OpenGL library lacks ") + name);
  }
  return found;
}

}  // namespace feedscope::ui
