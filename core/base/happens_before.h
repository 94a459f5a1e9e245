#pragma once

namespace feedscope {

/// Informs the thread sanitizer that everything before `before()` happens before everything after `after()`,
/// where a library not compiled for it (TBB, Qt) synchronises by means invisible to the sanitizer. No effect
/// in other builds.
class HappensBefore {
 public:
  void before();
  void after();

 private:
  [[maybe_unused]] char place_ = 0;  ///< its address identifies the pair
};

}  // namespace feedscope
