#pragma once

#include <vector>

#include "core/analysis/agreement/path_matcher.h"

namespace feedscope {

/// When a motion first comes to a place of the programmed path.
class TimeLaw {
 public:
  TimeLaw() = default;
  /// Of the samples that fit; between them the time is that of an even motion.
  TimeLaw(const std::vector<double>& time, const MatchedRecord& matched);

  bool empty() const { return s_.size() < 2; }
  double first_s() const { return s_.front(); }  ///< [mm]
  double last_s() const { return s_.back(); }    ///< [mm]
  double at(double s) const;                     ///< clamped to what it covers [s]
  /// The same at a share of the longest pause within `near` of there; at(s) where there is none [s].
  double at(double s, double share, double near = 0) const;
  /// Where the motion is.
  struct Place {
    double s = 0;      ///< programmed path length [mm]
    double share = 0;  ///< of the pause there that is over; 0 in motion
  };
  Place place_at(double time) const;  ///< clamped to what it covers
  /// Farthest distance from the path between two places [mm].
  double distance(double from, double to) const;
  /// Where the motion is farthest from the path, of what is known between two places.
  struct Farthest {
    double s = 0;         ///< [mm]
    double distance = 0;  ///< [mm]
  };
  Farthest farthest(double from, double to) const;
  double distance_at(double s) const;  ///< clamped to what it covers; even between known places [mm]
  const std::vector<double>& places() const { return s_; }  ///< rising [mm]
  const std::vector<double>& times() const { return t_; }   ///< [s]

 private:
  std::vector<double> s_;
  std::vector<double> t_;
  std::vector<float> distance_;  ///< largest while the motion is at s_[i]
};

}  // namespace feedscope
