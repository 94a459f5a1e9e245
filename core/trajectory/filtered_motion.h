#pragma once

#include "core/trajectory/filter_walk.h"

namespace feedscope {

/// Velocity pulses smoothed by equal moving averages, from standstill to standstill (Ward 2021, eq 1-7;
/// models/ward/README.md). Stored as pulses: between their starts t_j and t_j + i T1 every axis is a
/// polynomial of degree n + 1, on arcs plus a harmonic. An evaluation here costs the pulses within one delay;
/// for many times in order use a FilterWalk on train().
class FilteredMotion {
 public:
  /// `start` on the clock of the trajectory [s]; `contour_error`: largest distance of a programmed point from
  /// the path [mm].
  FilteredMotion(double start, PulseTrain train, double contour_error = 0);

  double start() const { return start_; }                    ///< [s]
  void begin_later(double by) { start_ += by; }              ///< [s]
  double filter_time() const { return train_.filter_time; }  ///< T1 [s]
  double delay() const { return train_.delay(); }            ///< n T1 [s]
  double duration() const { return train_.duration(); }      ///< [s]
  double contour_error() const { return contour_error_; }    ///< [mm]
  const PulseTrain& train() const { return train_; }

  /// Motion at `t` from the start [s].
  Kinematics at(double t) const;
  /// True if one straight pulse fills the filters from `t0` to `t1`, so that the velocity is constant.
  bool is_settled(double t0, double t1) const;

 private:
  double start_;
  PulseTrain train_;
  double contour_error_ = 0;
};

}  // namespace feedscope
