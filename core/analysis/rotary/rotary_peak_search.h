#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/analysis/envelope/rotary_walk.h"
#include "core/analysis/run/axis_peaks.h"

namespace feedscope {

/// Largest magnitudes of all axes of a machine while its rotary axes turn. Samples each part of the motion at
/// some instants. The peak is narrowed down, if it can exceed the value so far, between two samples from
/// which a velocity or an acceleration rises towards the other one, and around a sample larger than its
/// neighbours.
class RotaryPeakSearch {
 public:
  /// Adds the current part of `walk`.
  void add(RotaryWalk& walk);

  /// Of A, B and C.
  const std::array<AxisPeaks, 3>& rotary() const { return rotary_; }
  /// Of X, Y and Z of the machine; none if they are unknown.
  const std::optional<std::array<AxisPeaks, 3>>& linear() const { return linear_; }

 private:
  static constexpr std::size_t count = 18;  // velocity, acceleration and jerk of six axes
  using Magnitudes = std::array<double, count>;
  struct Look {
    double time = 0;  // [s]
    Magnitudes of{};
    Magnitudes slope{};  ///< by time; unknown and 0 for jerks
  };

  Look look(RotaryWalk& walk, double time);
  void narrow_between(RotaryWalk& walk, const Look& from, const Look& to);
  void search(RotaryWalk& walk, std::size_t quantity, double low, double high);
  void narrow(RotaryWalk& walk, const Look& before, const Look& at, const Look& after);
  void narrow_at_end(RotaryWalk& walk, const Look& end, const Look& next);
  void look_closer();
  double found(std::size_t quantity) const;

  std::array<AxisPeaks, 3> rotary_{};
  std::optional<std::array<AxisPeaks, 3>> linear_;
  std::vector<double> times_;
  std::vector<Look> looks_;
};

}  // namespace feedscope
