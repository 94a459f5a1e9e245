#pragma once

#include <initializer_list>

namespace feedscope::ui {

/// A library loaded on demand, so that the program starts without it. It remains loaded until the process
/// ends.
class SharedLibrary {
 public:
  /// Loads the first existing one of `names`. Throws InputError naming the first one if none exists, or the
  /// reason if one cannot be loaded; std::bad_alloc if memory is lacking.
  explicit SharedLibrary(std::initializer_list<const char*> names);

  /// Points `function` at the library's function `name`; throws InputError if it is missing.
  template <typename Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_ = nullptr;
};

}  // namespace feedscope::ui
