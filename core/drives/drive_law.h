#pragma once

#include <array>
#include <cstddef>

#include "core/drives/set_course.h"
#include "core/machine/axis_drive.h"

namespace feedscope {

/// Motion of a motor; its position is relative to the set position at the start of the course.
struct MotorMotion {
  double offset = 0;    ///< [mm]
  double velocity = 0;  ///< [mm/s]
};

/// The linear drive of one axis: x/x_set = (Kv + f s)/(Tv s^2 + s + Kv), core/drives/README.md.
class DriveLaw {
 public:
  DriveLaw() = default;
  /// `axis`: name. Throws InputError with drive_problem().
  DriveLaw(const AxisDrive& drive, char axis);

  bool follows_exactly() const { return gain_ == 0; }
  /// Fastest rate of the drive's response [1/s]; 0 if it follows exactly.
  double fastest_rate() const { return fastest_; }
  /// Decay rate of the remaining error, or oscillation rate if the drive overshoots [1/s].
  double settling_rate() const { return slow_ > 0 ? slow_ : fastest_; }
  bool operator==(const DriveLaw&) const = default;

 private:
  friend class DriveStep;

  /// Terms of the power series of an impulse response, exact up to one time constant of the fastest pole.
  static constexpr std::size_t terms = 16;
  static constexpr std::size_t short_degree = 4;
  using Series = std::array<double, terms>;

  void find_poles();
  /// m-fold integral of the impulse response, divided by t^m, by powers of fastest_ t.
  Series integrated_impulse(std::size_t m) const;

  double gain_ = 0;         ///< Kv [1/s]; 0: follows exactly
  double feedforward_ = 0;  ///< f
  double lag_ = 0;          ///< Tv [s]
  double fastest_ = 0;
  /// Poles -half_ +- sqrt(square_) [1/s, 1/s2].
  double half_ = 0;
  double square_ = 0;
  double slow_ = 0;  ///< of two real poles [1/s]
  double fast_ = 0;
  /// integrated_impulse(m) of the two integrals from which DriveStep derives the lower ones, highest first:
  /// for courses of up to short_degree, and for others.
  std::array<Series, 2> short_series_{};
  std::array<Series, 2> long_series_{};
};

}  // namespace feedscope
