#pragma once

#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/spline_path.h"
#include "core/program/sinumerik/geometry/targets.h"

namespace feedscope::sinumerik {

/// Collects the points of ASPLINE, BSPLINE and CSPLINE over their blocks and writes the curve once it ends.
class Splines : private Part {
 public:
  /// All outlive it.
  Splines(Context& context, const Targets& targets, LastMotion& last)
      : Part(context), targets_(targets), last_(last) {}

  /// Moves the current block to `target`, programmed coordinates [mm], along the spline.
  void collect(const Vec3& target);
  /// Writes the collected spline, if there is one, before anything that depends on the position.
  void finish();
  bool begun() const { return spline_.begun(); }
  /// Start of the current block: the last point, or the position of the path.
  Vec3 position() const { return spline_.begun() ? spline_.last().at : path().position(); }

  /// BAUTO to ETAN, by its name.
  void set_end(std::string_view name) { spline_.set_end(name); }

 private:
  SplinePath::Point point_of_block(const Vec3& target) const;

  const Targets& targets_;
  LastMotion& last_;
  SplinePath spline_;
};

}  // namespace feedscope::sinumerik
