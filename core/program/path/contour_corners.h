#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/contour_plane.h"
#include "core/program/path/corner_rounding.h"
#include "core/program/path/path_motion.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Rounding or chamfer in place of the corner at the end of a motion.
struct CornerCut {
  enum class Kind : std::uint8_t {
    rounding,
    chamfer,            ///< `size` off both sides
    chamfer_by_length,  ///< `size` long
  };
  Kind kind = Kind::rounding;
  double size = 0;                                   ///< > 0 [mm]
  std::optional<double> feed = std::nullopt;         ///< [mm/s]; none: that of an adjacent motion
  bool feed_of_next = false;                         ///< of the motion after it, else of the one before it
  bool shrinks = false;                              ///< is reduced until it fits
  bool at_feed_only = false;                         ///< not next to a rapid
  bool modal = false;                                ///< of all corners: no report where there is none
  std::optional<std::uint32_t> line = std::nullopt;  ///< shown; none: that of the motion before it
  DiagnosticLog::Place place;
};

/// Cuts corners off a contour: roundings and chamfers between lines and arcs in a plane.
///
///     motion before         corner             motion after
///     ----------------------.  . . .  +
///                              `.     |        it is cut off from both
///                                `.   |
///                                  .  |
///
/// The motion before is pending until the next one is known. A corner that cannot be cut stays
/// sharp, and "corner" reports why.
class ContourCorners {
 public:
  explicit ContourCorners(DiagnosticLog& log) : log_(log) {}

  /// True if motions need not pass through it.
  bool is_idle() const { return !next_ && !held_; }
  /// Makes the next motion, in one piece or several up to end_motion(), end in this corner.
  void cut_next(const CornerCut& cut, const ContourPlane& plane);
  void end_motion();

  /// `from`: its start.
  void take(PathMotion motion, Vec3 from);
  /// Ends the contour.
  void finish();
  /// Motions in order; the caller removes them.
  std::vector<PathMotion>& ready() { return ready_; }

 private:
  struct Held {
    PathMotion motion;
    Vec3 from;
  };

  void resolve(PathMotion& next, Vec3& from);
  bool in_plane(const PathMotion& motion, const Vec3& from) const;
  PlaneCorner piece_of(const PlaneElement& first, const PlaneElement& second, double size) const;
  PlaneCorner largest_piece(const PlaneElement& first, const PlaneElement& second);
  void write(const PlaneCorner& piece, const PlaneElement& first, const PathMotion& next);
  void report(const Message& what, const Message& hint, Severity severity = Severity::error) const;
  void report(CornerFault fault) const;

  DiagnosticLog& log_;
  std::optional<CornerCut> next_;
  std::optional<CornerCut> corner_;  ///< at the end of the pending motion
  ContourPlane plane_;
  std::optional<Held> held_;
  std::vector<PathMotion> ready_;
};

}  // namespace feedscope
