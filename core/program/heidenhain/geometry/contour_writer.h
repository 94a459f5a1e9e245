#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/program/heidenhain/geometry/approach.h"
#include "core/program/path/path_writer.h"
#include "core/program/path/plane_element.h"

namespace feedscope::heidenhain {

/// The line that programs a motion.
struct BlockPlace {
  std::uint32_t line = 0;  ///< shown
  DiagnosticLog::Place place;
  std::uint8_t axes = 0;         ///< bit per axis programmed
  std::uint8_t incremental = 0;  ///< bits of axes programmed by a distance
};

struct ContourFeed {
  FeedMode mode = FeedMode::per_minute;
  double value = 0;    ///< as PathWriter::set_feed; 0: none yet
  bool rapid = false;  ///< FMAX
};

/// A line or an arc as programmed.
struct ContourElement {
  Vec3 target = Vec3::Zero();
  bool is_arc = false;
  Vec3 center = Vec3::Zero();  ///< arcs; along the axis it does not matter
  Plane plane = Plane::xy;     ///< arcs
  int turn = 1;                ///< arcs: 1 counter-clockwise against the plane's normal, -1 clockwise
  double extra_turns = 0;      ///< arcs
  double radius = 0;           ///< not 0: an arc by a radius for which there is no centre; it becomes a line
  ContourFeed feed;
  int side = 0;  ///< of the tool: 1 left of the contour, -1 right, 0 on it
  std::optional<double> tool_radius = std::nullopt;  ///< none: not known, the contour itself is shown
  BlockPlace place;
};

/// RND or CHF in place of a corner.
struct ContourCorner {
  bool rounding = true;
  double size = 0;  ///< radius or side [mm]
  std::optional<ContourFeed> feed;
  BlockPlace place;
};

/// APPR: the first point of the contour and the way there.
struct ContourApproach {
  ApproachShape shape;
  Vec3 target;         ///< first point of the contour
  ContourFeed travel;  ///< to the auxiliary point
  ContourFeed feed;    ///< from there on
  int side = 0;        ///< of the tool from the auxiliary point on
  std::optional<double> tool_radius = std::nullopt;
  BlockPlace place;
};

/// DEP: the way off the contour.
struct ContourDeparture {
  ApproachShape shape;
  Vec3 target;  ///< LCT: end point; others: only the height along the tool axis
  ContourFeed feed;
  ContourFeed curve_feed;  ///< of the line or arc next to the contour
  BlockPlace place;
};

/// Writes the path of contours from the blocks of a program. The last element is pending until the next
/// block, which may round its end or make it an approach. An approach is pending until the contour's first
/// element, which determines where it starts.
class ContourWriter {
 public:
  /// Both outlive it.
  ContourWriter(PathWriter& path, DiagnosticLog& log) : path_(path), log_(log) {}

  /// The working plane.
  void set_plane(Plane plane) { plane_ = plane; }
  Plane plane() const { return plane_; }

  /// End of the last element or approach [mm].
  Vec3 position() const;
  /// Unit tangent at the end of the last element, in the plane; none before any motion in it.
  std::optional<Vec2> direction() const;

  void add(const ContourElement& element);
  /// Adds a corner between the last element and the next one.
  void add_corner(const ContourCorner& corner);
  void approach(const ContourApproach& approach);
  /// Turns the pending line into an approach on a line and an arc; false if none is pending. `feed`: of the
  /// arc; none: that of the line.
  bool soften_approach(double radius, const std::optional<ContourFeed>& feed);
  void depart(const ContourDeparture& departure);
  /// Writes everything pending. Call it before anything else changes the path or its frame, and at the end.
  void flush();

 private:
  void write(const ContourElement& element);
  void write_held();
  void compensate(const ContourElement& element);
  void resolve_approach(const ContourElement& first);
  void hand_corner_on();
  void report_corner(const Message& what, const Message& hint);
  void report_approach(const BlockPlace& place, const Message& what, const Message& hint);
  /// Motion in the plane, then along the tool axis.
  void go(const Vec3& target, const ContourFeed& feed, const BlockPlace& place, int side = 0,
          std::optional<double> tool_radius = std::nullopt);
  std::optional<PlaneElement> curve_of(const Vec3& start, const ContourElement& element) const;
  ContourElement curve_element(const ApproachPath& path, const Vec3& target) const;

  PathWriter& path_;
  DiagnosticLog& log_;
  Plane plane_ = Plane::xy;
  bool held_ = false;
  ContourElement last_;  ///< pending, or written last
  Vec3 last_start_ = Vec3::Zero();
  std::optional<ContourCorner> corner_;
  std::optional<ContourApproach> approach_;
  double beside_ = 0;  ///< the compensation in force, positive to the left [mm]
};

}  // namespace feedscope::heidenhain
