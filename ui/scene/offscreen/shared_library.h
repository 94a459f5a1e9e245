#pragma once

#include <initializer_list>

namespace feedscope::ui {

/// A library that is looked for when it is needed, so that the program starts where it is not installed. It
/// stays loaded until the process ends.
class SharedLibrary {
 public:
  /// The first of `names` that is there. Throws InputError naming the first one if none is, or the reason if
  /// one is there but cannot be loaded; std::bad_alloc if that is for lack of memory.
  explicit SharedLibrary(std::initializer_list<const char*> names);

  /// Points `function` at the one of that name; throws InputError if the library lacks it.
  template <typename Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_ = nullptr;
};

}  // namespace feedscope::ui
