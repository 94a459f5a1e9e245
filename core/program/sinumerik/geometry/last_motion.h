#pragma once

#include <optional>

#include "core/base/geometry.h"
#include "core/program/path/path_writer.h"

namespace feedscope::sinumerik {

/// The last motion of the path, for motions that continue it tangentially: CT, splines with BTAN. Programmed
/// coordinates [mm].
class LastMotion {
 public:
  /// Sets the start of the last motion of the path.
  void set_start(const Vec3& start) { start_ = start; }
  void set_line() { arc_.reset(); }
  void set_arc_by_center(const ArcRequest& arc) { set_arc(arc, false); }
  void set_arc_by_radius(const ArcRequest& arc) { set_arc(arc, true); }

  /// Unit vector along the end of the motion, which is the end of `path`; zero before the first motion.
  Vec3 direction(const PathWriter& path) const;

 private:
  void set_arc(const ArcRequest& arc, bool by_radius) {
    arc_ = arc;
    by_radius_ = by_radius;
  }

  Vec3 start_ = Vec3::Zero();
  std::optional<ArcRequest> arc_;  ///< none: a line
  bool by_radius_ = false;         ///< arc_ has a radius instead of a centre
};

}  // namespace feedscope::sinumerik
