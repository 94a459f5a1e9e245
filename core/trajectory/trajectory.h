#pragma once

// Room `trajectory`: the motion as a function of time. A Trajectory has pieces of constant jerk or filtered
// pulses over a BlendedPath; State is everything at one instant, exact, by time or by path length.
// TrajectoryBuilder makes it, the walks (part_walk.h, state_walk.h, length_walk.h) run through it in order at
// constant cost.

#include <cstdint>
#include <memory>
#include <vector>

#include "core/blend/blended_path.h"
#include "core/trajectory/filtered_motion.h"
#include "core/trajectory/length_walk.h"
#include "core/trajectory/piece.h"

namespace feedscope {

class PartWalk;

/// State at one time. Vectors by the chain rule from curve and law; nothing is differenced.
struct State {
  double time = 0;                     ///< [s]
  double path_length = 0;              ///< executed, from the start [mm]
  Vec3 position;                       ///< [mm]
  Vec3 velocity;                       ///< [mm/s]
  Vec3 acceleration;                   ///< [mm/s2]
  Vec3 jerk;                           ///< [mm/s3]
  double speed = 0;                    ///< [mm/s]
  double tangential_acceleration = 0;  ///< dv/dt [mm/s2]
  double tangential_jerk = 0;          ///< d2v/dt2 [mm/s3]
  double programmed_feed = 0;          ///< [mm/s]; for a rapid the axes' speed along it
  std::uint32_t line = 0;              ///< source line
  std::uint32_t element = 0;           ///< index into the BlendedPath
  Cause cause;
  Cause slower_place;  ///< where `cause` is ramp_down, cause of the speed at the place ahead; else `cause`
};

/// One curve that the control put into a corner, a cubic blend or an arc (see its element's kind). Where two
/// blocks overlap in it, `element` is the first of several lines and `min_radius` is not known (NaN). On
/// filtered motion the part made by the corner's blending pulses: `transition` is the programmed length of
/// the longer one, `epsilon` and `min_radius` those at the closest approach.
struct BlendRecord {
  std::uint32_t line = 0;     ///< of the block that ends at the corner
  std::uint32_t element = 0;  ///< index into the BlendedPath; filtered: the one that ends at the corner
  Vec3 corner;                ///< programmed [mm]
  double turn = 0;            ///< direction change [rad]
  double transition = 0;      ///< T, from the corner to the blend's ends [mm]
  double epsilon = 0;         ///< distance of the corner from the blend [mm]
  double length = 0;          ///< [mm]
  double min_radius = 0;      ///< [mm]
  double entry_speed = 0;     ///< [mm/s]
  double exit_speed = 0;      ///< [mm/s]
};

/// Motion of the machine according to a control model: executed path and time law as exact pieces.
class Trajectory {
 public:
  /// Data that a TrajectoryBuilder collects.
  struct Content {
    BlendedPath path;
    std::vector<Piece> pieces;          ///< in order of time and of elements
    double duration = 0;                ///< [s]
    Vec3 axis_velocity = Vec3::Zero();  ///< of rapids and of blocks without feed [mm/s]
    double compaction_error = 0;
    std::vector<FilteredMotion> motions;
    std::vector<std::uint32_t> filtered_corners;  ///< elements that end at such a corner
  };

  Trajectory() = default;
  explicit Trajectory(Content content) : content_(std::move(content)) {}

  double duration() const { return content_.duration; }          ///< cycle time [s]
  double path_length() const { return content_.path.length(); }  ///< executed [mm]
  const BlendedPath& path() const { return content_.path; }
  const Content& content() const { return content_; }
  Content take() && { return std::move(content_); }
  const std::vector<Piece>& pieces() const { return content_.pieces; }
  const std::vector<FilteredMotion>& motions() const { return content_.motions; }
  /// Largest distance of an omitted programmed point from the executed path [mm].
  double compaction_error() const { return content_.compaction_error; }

  /// Corners that the control rounds, in order of the path.
  std::size_t blend_count() const;
  BlendRecord blend(std::size_t i) const;
  /// The same for many corners in order, which share the cache of `filters` on filtered motion.
  BlendRecord blend(std::size_t i, FilterWalk& filters) const;

  /// State at a time, clamped to [0, duration]. At a piece border, state of the piece that begins there. An
  /// empty trajectory gives a State at the origin, at rest.
  State state(double time) const;
  /// State at the first time at which the path length is `s`, clamped to [0, path_length()].
  State state_at_path(double s) const;
  std::size_t piece_at(double time) const;
  double piece_end(std::size_t piece) const;  ///< [s]
  /// Last of the elements [piece.element, last_element()] that a piece may cross.
  std::uint32_t last_element(std::size_t piece) const;
  /// Cause of the speed at the place ahead, of a piece that slows down (cause ramp_down); else the piece's
  /// own cause.
  Cause slower_place(std::size_t piece) const;
  /// Number of equal parts of a filtered part such that each lasts at most 1/`a_filter_time` of the filter
  /// time; 1 where its velocity is constant.
  int filtered_spans(const Part& part, double a_filter_time) const;
  double filtered_length(const Part& part) const;  ///< path length of a filtered part [mm]
  /// Path length from the start of its element, `tau` from the start of a filtered piece [s], [mm]:
  /// interpolated by a SpanCourse between the stored lengths of both ends of the piece.
  double filtered_q(std::size_t piece, double tau, FilterWalk& filters) const;
  const FilteredMotion& motion_of(std::uint32_t element) const {
    return content_.motions[content_.path.index(element)];
  }

  std::uint32_t line_of(std::size_t element) const { return segment_of(element).line; }
  double feed_of(std::size_t element) const;  ///< [mm/s]; the axes' speed for a rapid
  bool is_rapid(std::size_t element) const { return segment_of(element).rapid; }
  /// First time at which the block of `line`, or of the nearest later line that moves, is running.
  double time_of_line(std::uint32_t line) const;

 private:
  friend class TrajectoryBuilder;
  /// `record` with the speeds at the start of its element and at the end of `last_element`.
  BlendRecord with_speeds(BlendRecord record, std::uint32_t last_element) const;
  const Segment& segment_of(std::size_t element) const { return content_.path.source_segment(element); }
  double filtered_end(std::size_t piece) const;  ///< q at the end of a filtered piece [mm]
  /// The filtered piece's span of its motion.
  SpanCourse filtered_course(std::size_t piece, FilterWalk& filters) const;
  /// Time from the start of a piece until it reaches q [s].
  double time_in_piece(std::size_t piece, double q) const;
  /// Parts from the first one on `element`.
  PartWalk walk_from(std::uint32_t element) const;

  Content content_;
};

}  // namespace feedscope
