#pragma once

#include <cstddef>

namespace feedscope::benchmark {

/// Heap in use through operator new, which this executable replaces to count it.
class HeapMeter {
 public:
  /// Counts from now on; meters do not nest.
  HeapMeter();
  /// Largest growth since construction [bytes].
  std::size_t peak() const;
  /// Growth that is still there [bytes].
  std::size_t held() const;

 private:
  std::size_t start_;
};

}  // namespace feedscope::benchmark
