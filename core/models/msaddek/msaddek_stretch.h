#pragma once

#include "core/base/progress.h"
#include "core/blend/compaction.h"
#include "core/blend/connecting_arc.h"
#include "core/compressor/compressor.h"
#include "core/machine/settings.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

enum class MsaddekLaw { dynamic_feed, static_feed };

/// Settings of the model in internal units.
struct MsaddekSettings {
  double compaction = 0;        ///< [mm]; 0: none
  double period = 0.002;        ///< t_cy [s]
  double curvature_jerk = 0;    ///< J_tcurv = J_curv r_jct [mm/s3]
  std::uint32_t lookahead = 0;  ///< blocks
  MsaddekLaw law = MsaddekLaw::dynamic_feed;
  CompressorSettings compressor;

  explicit MsaddekSettings(const Settings& settings);
};

/// Runs stretches into a trajectory, one after the other: lays connecting arcs into the corners of the
/// compacted path, sets the static feed of every element, and moves at it or by ramps below it. Segments are
/// those of the compacted path, blocks the programmed ones.
class MsaddekRunner {
 public:
  /// `programmed`: source of `compacted`; `rules`: of the compacted path, TIT is their tolerance.
  MsaddekRunner(const Toolpath& programmed, const CompactedPath& compacted, const PathRules& rules,
                const AxisVectors& axes, const MsaddekSettings& settings, TrajectoryBuilder& builder);

  /// Programmed lines and arcs without a stop between them; their chords may need further stops.
  void run(const StretchRange& range, ProgressSteps& steps);

 private:
  void lay_path(const StretchRange& chords);
  /// `part`: limits of a part of it; null: of all of it.
  MotionLimits static_limits(std::size_t segment, const StretchRange& chords,
                             const TurnPart* part = nullptr) const;
  /// `limits`: of all of the segment.
  void add_line(std::size_t segment, double cut_before, double cut_after, const MotionLimits& limits,
                const StretchRange& chords);
  void add_arc(std::size_t segment, const MotionLimits& limits);
  void add_curve(const SmoothCurve& curve);
  void add_connection(std::size_t segment, const StretchRange& chords, const ConnectingArc& connection);
  /// eq 17: lowers a speed to the limit of the curvilinear jerk at curvature `k` [1/mm].
  void lower_by_curvature(SpeedBound& speed, double k) const;

  void move_static(ProgressSteps& steps);
  void move_dynamic(ProgressSteps& steps);

  const Toolpath& programmed_;
  const CompactedPath& compacted_;
  const PathRules& rules_;
  AxisVectors axes_;
  MsaddekSettings settings_;
  TrajectoryBuilder& builder_;
  Compressor compressor_;  ///< of the compacted path, which is the programmed one while it is on
  Stretch stretch_;
};

}  // namespace feedscope
