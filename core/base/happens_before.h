#pragma once

namespace feedscope {

/// Tells the thread sanitizer that all before `before()` happens before all behind `after()`, where a library
/// that is not compiled for it (TBB, Qt) makes it so by means that the sanitizer does not see. Nothing
/// elsewhere.
class HappensBefore {
 public:
  void before();
  void after();

 private:
  [[maybe_unused]] char place_ = 0;  ///< its address stands for the pair
};

}  // namespace feedscope
