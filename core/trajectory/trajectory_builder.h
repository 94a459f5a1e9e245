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
  /// `axis_velocity`: of rapids and of blocks without feed [mm/s]. `compacted`: as of BlendedPath.
  TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity,
                    std::shared_ptr<const CompactedPath> compacted);
  TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity)
      : TrajectoryBuilder(std::move(programmed), axis_velocity, std::shared_ptr<const CompactedPath>()) {}
  /// `executed`: as of BlendedPath.
  TrajectoryBuilder(std::shared_ptr<const Toolpath> programmed, const Vec3& axis_velocity,
                    std::shared_ptr<const ExecutedPath> executed);
  /// The path of another run, to be passed in another time.
  explicit TrajectoryBuilder(const Trajectory& same_path);

  /// Makes room for that many, so that long programs are not copied while they grow.
  void reserve(std::size_t elements, std::size_t pieces);
  /// The same for `most` more pieces, and, going by those of the first `done` elements, for all that are to
  /// come on the path.
  void reserve_for_path(std::size_t most, std::size_t done);
  /// A builder of the same program that begins at the clock's zero and is to be appended to this one.
  TrajectoryBuilder part() const;
  /// Appends what a part() holds. `done`: share of the whole program that is run then, by which room is made
  /// for the rest, (0, 1].
  void append(TrajectoryBuilder part, double done);
  /// From now on adding throws Cancelled soon after `progress` was cancelled, which may be null and outlives
  /// this and its parts.
  void stop_with(const Progress* progress) { progress_ = progress; }
  /// Of stop_with(), for work between what is added.
  const Progress* progress() const { return progress_; }
  void set_blend_weight(double alpha) { content().path.set_blend_weight(alpha); }

  /// Appends programmed segment `block`, a line, an arc or a dwell; `length`: what corners leave of it, or
  /// what stands for it on the compacted path [mm]. Returns the element's index.
  std::uint32_t add_segment(std::uint32_t block, double length);
  /// The whole segment.
  std::uint32_t add_segment(std::uint32_t block);
  /// Appends dwell `block` with its time.
  void add_pause(std::uint32_t block);
  /// The same for one whose element is part of the path already.
  void pass_pause(std::uint32_t element);
  /// The same for one that the control gives `time` [s].
  void pass_pause(std::uint32_t element, double time);
  /// Appends the curve, a blend or a connecting arc, from `transition` before the end of `block` to as much
  /// behind it [mm].
  std::uint32_t add_corner(ElementKind kind, std::uint32_t block, double transition, double length);
  /// Appends segment `block` as `motion` passes it.
  std::uint32_t add_filtered(std::uint32_t block, double length, std::uint32_t motion);
  /// As BlendedPath::add_fitted.
  std::uint32_t add_fitted(std::uint32_t block, std::span<const CourseKnot> course) {
    count_addition();
    return content().path.add_fitted(block, course);
  }
  /// As BlendedPath::begin_curve and add_curve.
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
  /// Says that the element added last ends at a corner that the filters round.
  void add_filtered_corner() {
    content().filtered_corners.push_back(static_cast<std::uint32_t>(path().size() - 1));
  }

  /// Appends a piece that lasts `duration` [s]; `piece.time` is set here. Nothing for duration <= 0, nor
  /// for one that is lost in the rounding of the time reached.
  void add_piece(Piece piece, double duration);
  /// The same of a piece at constant speed by path length: where the one before runs at that speed for the
  /// same cause, it goes on over this element instead.
  void add_level_piece(const Piece& piece, double duration);
  /// A place in the motion: what is added next begins there.
  struct Mark {
    std::size_t piece;
    double time;  ///< [s]
  };
  Mark mark() const { return {content().pieces.size(), content().duration}; }
  /// Forgets everything from `start` on.
  void take_back(const Mark& start);
  /// Passes everything from `start` on slower by `factor` >= 1: times grow by it, velocities fall by it.
  void slow_down(const Mark& start, double factor);

  /// Where programmed points are omitted of the path: largest distance of one from it [mm].
  void set_compaction_error(double error) { content().compaction_error = error; }

  const BlendedPath& path() const { return content().path; }
  const Toolpath& programmed() const { return *content().path.programmed(); }
  /// What has been added until now.
  const Trajectory& so_far() const { return so_far_; }
  double time() const { return content().duration; }
  /// Index of the motion that is added next.
  std::uint32_t motion_count() const { return static_cast<std::uint32_t>(content().motions.size()); }
  /// The trajectory of everything added; the builder is empty then. A piece of cause ramp_down that does not
  /// say what it slows down for takes the cause of what follows the slowing, or exact_stop where that begins
  /// at rest.
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
