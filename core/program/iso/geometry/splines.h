#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/program/iso/context.h"
#include "core/program/iso/geometry/targets.h"
#include "core/program/path/parametric_curve.h"

namespace feedscope::iso {

/// Runs LinuxCNC's splines G5 (cubic), G5.1 (quadratic), G5.2 and G5.3 (NURBS), and Fanuc's G6.2 (NURBS).
class Splines : private Part {
 public:
  /// Both outlive it.
  Splines(Context& context, Targets& targets) : Part(context), targets_(targets) {}

  /// The G word of a spline.
  void begin(const GCode& code, const Word& word);
  /// True if a block moves although it names no axis, while a spline is in force.
  bool moves_without_axes() const;
  /// Runs a block while a spline is in force.
  void run();
  /// Writes a NURBS that is not closed, before another motion or the end of the program.
  void finish();

 private:
  struct ControlPoint {
    Vec3 at = Vec3::Zero();  ///< [mm]
    double weight = 1;
    std::uint32_t line = 0;  ///< shown
    DiagnosticLog::Place place;
  };
  struct Nurbs {
    std::vector<ControlPoint> points;  ///< empty outside of G5.2 and G6.2
    std::size_t order = 3;
    Vec3 end = Vec3::Zero();    ///< last point [mm]
    std::vector<double> knots;  ///< Fanuc's; empty: a clamped curve
  };

  void cubic();
  void quadratic();
  /// Parameter from 0 to 1, in programmed coordinates.
  void write_curve(const ParametricCurve& curve) const;
  /// In the plane XY [mm].
  Vec3 offset_words(char first, char second) const;
  /// Returns true, with a report and a line instead, if the block has neither of the two.
  bool lacks_words(char first, char second);
  void add_control_point();
  void add_fanuc_control_point();
  ControlPoint control_point(const Vec3& at, double weight) const;
  void end_nurbs();
  void end_fanuc_nurbs();
  void write_nurbs(const std::vector<ControlPoint>& points, const std::vector<double>& knots) const;

  Targets& targets_;
  bool has_tangent_ = false;
  /// From the end of the last G5 to the control point that continues straight [mm].
  Vec3 tangent_ = Vec3::Zero();
  Nurbs nurbs_;
};

}  // namespace feedscope::iso
