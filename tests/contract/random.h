#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace feedscope::contract {

/// Random numbers that are the same with every standard library.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t number) : bits_(seed * 0x9E3779B97F4A7C15U + number) {
    bits_.discard(4);
  }

  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  ///< [0, 1)
  double between(double low, double high) { return low + (high - low) * unit(); }
  double spread(double low, double high) {
    return low * std::pow(high / low, unit());
  }  ///< even in orders of size
  bool chance(double share) { return unit() < share; }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(unit() * static_cast<double>(count));
  }
  double sign() { return chance(0.5) ? 1 : -1; }

 private:
  std::mt19937_64 bits_;
};

}  // namespace feedscope::contract
