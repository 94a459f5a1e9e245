#pragma once

#include <vector>

#include "core/analysis/agreement/path_matcher.h"

namespace feedscope {

/// Time at which a motion first reaches each place of the programmed path.
class TimeLaw {
 public:
  TimeLaw() = default;
  /// From the samples that match; time is interpolated linearly between them.
  TimeLaw(const std::vector<double>& time, const MatchedRecord& matched);

  bool empty() const { return s_.size() < 2; }
  double first_s() const { return s_.front(); }  ///< [mm]
  double last_s() const { return s_.back(); }    ///< [mm]
  double at(double s) const;                     ///< clamped to the covered range [s]
  /// Time at a share of the longest pause within `near` of `s`; at(s) without a pause [s].
  double at(double s, double share, double near = 0) const;
  /// Place of the motion at a time.
  struct Place {
    double s = 0;      ///< programmed path length [mm]
    double share = 0;  ///< elapsed part of the pause there; 0 in motion
  };
  Place place_at(double time) const;  ///< clamped to the covered range
  /// Largest distance from the path between two places [mm].
  double distance(double from, double to) const;
  /// Place between two others with the largest known distance from the path.
  struct Farthest {
    double s = 0;         ///< [mm]
    double distance = 0;  ///< [mm]
  };
  Farthest farthest(double from, double to) const;
  double distance_at(double s) const;  ///< clamped to the covered range, linear between known places [mm]
  const std::vector<double>& places() const { return s_; }  ///< rising [mm]
  const std::vector<double>& times() const { return t_; }   ///< [s]

 private:
  std::vector<double> s_;
  std::vector<double> t_;
  std::vector<float> distance_;  ///< largest while the motion is at s_[i]
};

}  // namespace feedscope
