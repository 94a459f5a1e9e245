#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Collects path and time law of a run in the order in which they are executed.
class TrajectoryBuilder {
 public:
  /// `axis_velocity`: for rapids and blocks without feed [mm/s]. `compacted`: as in BlendedPath.
  TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity,
                    std::shared_ptr<const CompactedPath> compacted);
  TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity)
      : TrajectoryBuilder(std::move(programmed), axis_velocity, std::shared_ptr<const CompactedPath>()) {}
  /// `executed`: as in BlendedPath.
  TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity,
                    std::shared_ptr<const ExecutedPath> executed);
  /// Starts with the path of another run, to be passed in another time.
  explicit TrajectoryBuilder(const Trajectory& same_path);

  /// Reserves room for that many, so that long programs are not copied while they grow.
  void reserve(std::size_t elements, std::size_t pieces);
  /// The same for `most` more pieces, and for all pieces still to come on the path, estimated from those of
  /// the first `done` elements.
  void reserve_for_path(std::size_t most, std::size_t done);
  /// Returns a builder of the same program that begins at time zero and is to be appended to this one.
  TrajectoryBuilder part() const;
  /// Appends the content of a part(). `done`: share of the whole program run by then, from which the room for
  /// the rest is estimated, (0, 1].
  void append(TrajectoryBuilder part, double done);
  /// Makes additions throw Cancelled soon after `progress` was cancelled. `progress` may be null and outlives
  /// this and its parts.
  void stop_with(const Progress* progress) { progress_ = progress; }
  /// Progress of stop_with(), for work between additions.
  const Progress* progress() const { return progress_; }
  void set_blend_weight(double alpha) { content().path.set_blend_weight(alpha); }

  /// Appends programmed segment `block`, a line, an arc or a dwell. `length`: the rest of it between corners,
  /// or of its line on the compacted path [mm]. Returns the element's index.
  std::uint32_t add_segment(std::uint32_t block, double length);
  /// Appends the whole segment.
  std::uint32_t add_segment(std::uint32_t block);
  /// Appends dwell `block` with its time.
  void add_pause(std::uint32_t block);
  /// The same for a dwell whose element is already part of the path.
  void pass_pause(std::uint32_t element);
  /// The same with the control's own `time` [s].
  void pass_pause(std::uint32_t element, double time);
  /// Appends a blend or a connecting arc, from `transition` before the end of `block` to the same distance
  /// after it [mm].
  std::uint32_t add_corner(ElementKind kind, std::uint32_t block, double transition, double length);
  /// Appends segment `block` as `motion` passes it.
  std::uint32_t add_filtered(std::uint32_t block, double length, std::uint32_t motion);
  /// Same as BlendedPath::add_fitted.
  std::uint32_t add_fitted(std::uint32_t block, std::span<const CourseKnot> course) {
    count_addition();
    return content().path.add_fitted(block, course);
  }
  /// Same as BlendedPath::begin_curve and add_curve.
  void begin_curve(const CourseKnot& knot) { content().path.begin_curve(knot); }
  std::uint32_t add_curve(std::uint32_t block, const CourseKnot& to) {
    count_addition();
    return content().path.add_curve(block, to);
  }
  /// Appends segment `i` of the executed path. Returns the element's index.
  std::uint32_t add_executed(std::uint32_t i) {
    count_addition();
    return content().path.add_executed(i);
  }
  std::uint32_t add_motion(FilteredMotion motion);
  /// Marks that the last element ends at a corner rounded by the filters.
  void add_filtered_corner() {
    content().filtered_corners.push_back(static_cast<std::uint32_t>(path().size() - 1));
  }

  /// Appends a piece that lasts `duration` [s] and sets `piece.time`. Does nothing for duration <= 0 or below
  /// the rounding of the time reached.
  void add_piece(Piece piece, double duration);
  /// The same for a piece at constant speed by path length: if the piece before has that speed and the same
  /// cause, extends it over this element instead.
  void add_level_piece(const Piece& piece, double duration);
  /// A place in the motion: the next addition begins there.
  struct Mark {
    std::size_t piece;
    double time;  ///< [s]
  };
  Mark mark() const { return {content().pieces.size(), content().duration}; }
  /// Removes everything after `start`.
  void take_back(const Mark& start);
  /// Slows down everything after `start` by `factor` >= 1: multiplies times and divides velocities by it.
  void slow_down(const Mark& start, double factor);

  /// For a path that omits programmed points: largest distance of one from it [mm].
  void set_compaction_error(double error) { content().compaction_error = error; }

  const BlendedPath& path() const { return content().path; }
  const Toolpath& programmed() const { return *content().path.programmed(); }
  /// Everything added so far.
  const Trajectory& so_far() const { return so_far_; }
  double time() const { return content().duration; }
  /// Index of the next motion to be added.
  std::uint32_t motion_count() const { return static_cast<std::uint32_t>(content().motions.size()); }
  /// Returns the trajectory of everything added and leaves the builder empty. A piece of cause ramp_down
  /// without a given slower place takes the cause of whatever follows the slowing, or exact_stop where that
  /// begins at rest.
  Trajectory finish();

 private:
  TrajectoryBuilder() = default;
  void name_slower_places();
  void count_addition() {
    constexpr std::uint32_t between_looks = 1024;
    if (++additions_ % between_looks == 0) {
      stop_if_cancelled(progress_);
    }
  }

  Trajectory::Content& content() { return so_far_.content_; }
  const Trajectory::Content& content() const { return so_far_.content_; }

  Trajectory so_far_;
  const Progress* progress_ = nullptr;
  std::uint32_t additions_ = 0;
};

}  // namespace feedscope
