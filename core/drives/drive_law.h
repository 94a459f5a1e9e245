#pragma once

#include <array>
#include <cstddef>

#include "core/machine/axis_drive.h"

namespace feedscope {

/// Set position of one axis over a short time: a polynomial, as its derivatives at the start.
struct SetCourse {
  static constexpr std::size_t order = 7;  ///< highest derivative that is not 0

  std::array<double, order + 1> derivative{};  ///< [0] position [mm], [k] its k-th derivative [mm/s^k]
  double duration = 0;                         ///< [s]

  /// Distance from the position at the start, `h` [s] after it [mm].
  double travel(double h) const;
  double velocity(double h) const;  ///< [mm/s]
};

/// Motion of a motor, its position as distance from the set position where the course began.
struct MotorMotion {
  double offset = 0;    ///< [mm]
  double velocity = 0;  ///< [mm/s]
};

/// The linear drive of one axis: x/x_set = (Kv + f s)/(Tv s^2 + s + Kv), core/drives/README.md.
class DriveLaw {
 public:
  DriveLaw() = default;
  /// Throws InputError as drive_problem() says, for the axis of this name.
  DriveLaw(const AxisDrive& drive, char axis);

  bool follows_exactly() const { return gain_ == 0; }
  /// Fastest rate at which the drive answers [1/s]; 0 where it follows exactly.
  double fastest_rate() const { return fastest_; }
  /// Time in which what is left of an error shrinks by a factor of e [s].
  double settling_time() const { return settling_; }

 private:
  friend class DriveCourse;

  double gain_ = 0;         ///< Kv [1/s]; 0: follows exactly
  double feedforward_ = 0;  ///< f
  double lag_ = 0;          ///< Tv [s]
  double fastest_ = 0;
  double settling_ = 0;
  /// Poles -half_ +- sqrt(square_) [1/s, 1/s2].
  double half_ = 0;
  double square_ = 0;
  double slow_ = 0;  ///< of two real poles [1/s]
  double fast_ = 0;
};

/// Answer of a drive to one set course, in closed form. Over times shorter than the drive's it is the power
/// series of the solution, which has no cancellation; over longer ones the polynomial that remains after
/// settling, and what is left of the deviation from it, as exponentials.
class DriveCourse {
 public:
  DriveCourse() = default;
  DriveCourse(const DriveLaw& law, const SetCourse& set, const MotorMotion& start);

  /// `h` [s] after the start, 0 <= h <= duration.
  MotorMotion at(double h) const;
  /// Motion at the end, as the start of the next course.
  MotorMotion at_end() const;

 private:
  static constexpr std::size_t terms = 24;
  enum class Kind : unsigned char { exact, series, settled };

  void expand(const DriveLaw& law, const MotorMotion& start);
  void settle(const DriveLaw& law, const MotorMotion& start);
  /// k-th derivative at the start of Kv x + f x', x from the start of the course.
  double drive_input(const DriveLaw& law, std::size_t k) const;

  const DriveLaw* law_ = nullptr;
  SetCourse set_;
  Kind kind_ = Kind::exact;
  std::size_t count_ = 0;
  std::array<double, terms> series_{};  ///< of the offset by h/duration, or of the settled offset by h
  MotorMotion left_;                    ///< deviation from the settled motion at the start
};

}  // namespace feedscope
