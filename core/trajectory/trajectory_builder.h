#pragma once

#include <cstdint>
#include <vector>

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Collects path, time law and per-element facts of a run in the order in which they are executed.
class TrajectoryBuilder {
 public:
  TrajectoryBuilder() = default;
  /// The path of another run, to be passed in another time.
  explicit TrajectoryBuilder(const Trajectory& same_path);

  /// Makes room for that many, so that long programs are not copied while they grow.
  void reserve(std::size_t elements, std::size_t pieces);
  /// Appends `element`, whose `s` is set here; `feed` [mm/s]. Returns its index.
  std::uint32_t add_element(PathElement element, std::uint32_t line, double feed, bool rapid);
  /// Appends segment `i`, shortened by `cut_before` and `cut_after` [mm] where blends take its place; `feed`
  /// [mm/s]. Returns the element's index.
  std::uint32_t add_segment(const Toolpath& toolpath, std::size_t i, double feed, double cut_before = 0,
                            double cut_after = 0);
  std::uint32_t add_arc(const Arc& arc);
  std::uint32_t add_blend(const CubicBlend& blend);
  std::uint32_t add_motion(FilteredMotion motion);

  /// Appends a piece that lasts `duration` [s]; `piece.time` is set here. Nothing for duration <= 0.
  void add_piece(Piece piece, double duration);
  /// A place in the motion: what is added next begins there.
  struct Mark {
    std::size_t piece;
    double time;  ///< [s]
  };
  Mark mark() const { return {pieces_.size(), time_}; }
  /// Passes everything from `start` on slower by `factor` >= 1: times grow by it, velocities fall by it.
  void slow_down(const Mark& start, double factor);

  /// Entry and exit speed are filled in by finish().
  void add_blend_record(const BlendRecord& record) { records_.push_back(record); }

  /// Where programmed points are left out of the path: largest distance of one from it [mm].
  void set_compaction_error(double error) { compaction_error_ = error; }

  const BlendedPath& path() const { return path_; }
  double time() const { return time_; }
  /// Index of the element, and of the motion, that is added next.
  std::uint32_t element_count() const { return static_cast<std::uint32_t>(path_.elements.size()); }
  std::uint32_t motion_count() const { return static_cast<std::uint32_t>(motions_.size()); }
  /// The trajectory of everything added; the builder is empty then.
  Trajectory finish();

 private:
  BlendedPath path_;
  std::vector<Piece> pieces_;
  std::vector<BlendRecord> records_;
  std::vector<std::uint32_t> lines_;
  std::vector<double> feeds_;
  std::vector<bool> rapid_;
  std::vector<FilteredMotion> motions_;
  double time_ = 0;
  double compaction_error_ = 0;
};

}  // namespace feedscope
