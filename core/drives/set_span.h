#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/drives/set_course.h"

namespace feedscope {

/// Set positions over a short time, a polynomial for each coordinate.
struct SetSpan {
  double time = 0;      ///< start [s]
  double duration = 0;  ///< [s]
  std::array<SetCourse, 3> axes;
  Vec3 start = Vec3::Zero();  ///< [mm]
  std::uint32_t element = 0;  ///< current one of the path
  /// The motion restarts from rest here: at the start of the program, and after a move of unknown path.
  bool begins = false;

  double end() const { return time + duration; }         ///< [s]
  Vec3 at(double h) const;                               ///< set position `h` [s] after the start [mm]
  std::size_t degree() const { return axes[0].degree; }  ///< of all axes

  /// Sets the courses to polynomials of this degree and duration [s] from `position` [mm] on, with
  /// derivatives 0.
  void begin(const Vec3& position, std::size_t degree, double lasting);
  void set_derivative(std::size_t order, const Vec3& value) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      axes[axis].derivative[order] = value[static_cast<Eigen::Index>(axis)];
    }
  }
};

}  // namespace feedscope
