#pragma once

#include <algorithm>
#include <vector>

#include "core/base/progress.h"
#include "core/compressor/smooth_course.h"
#include "core/compressor/smoothing_run.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Settings of the compressor in inside units.
struct CompressorSettings {
  bool on = false;
  CompressorRule rule;
  double smoothing = 0;        ///< as SmoothingRule
  double tolerance_share = 1;  ///< of the contour tolerance that curves through blocks may use

  CompressorSettings() = default;
  explicit CompressorSettings(const Settings& settings);
  /// Whether any block of `toolpath` may be smoothed.
  bool smooths(const Toolpath& toolpath) const;
};

/// The settings that models with a compressor read: compressor, compressor_block_mm, compressor_angle_deg,
/// compressor_smoothing.
const std::vector<SettingSpec>& compressor_settings();

/// `own` and these behind them.
std::vector<SettingSpec> with_compressor(std::vector<SettingSpec> own);

/// A smooth curve in the place of a run of lines.
struct SmoothCurve {
  SmoothingRun run;
  std::vector<CourseKnot> knots;      ///< s from 0; at least two
  std::vector<std::uint32_t> blocks;  ///< segment under each knot but the last
  double tolerance = 0;               ///< largest distance from the run that was allowed [mm]
};

/// Lays smooth curves along curves of the program (splines, polynomials) that the reader has made tangent
/// arcs of, within curve_tolerance, always; and through dense short blocks, if it is on, as compressors and
/// spline functions of controls do. Which curve a control lays is published nowhere: this one is our own,
/// within what the makers say of theirs (README.md beside this file).
class Compressor {
 public:
  /// `toolpath` and `rules` outlive it.
  Compressor(const Toolpath& toolpath, const PathRules& rules, const CompressorSettings& settings)
      : toolpath_(toolpath), rules_(rules), settings_(settings) {
    settings_.rule.lines = settings.on;
    has_curves_ = std::any_of(toolpath.segments.begin(), toolpath.segments.end(),
                              [](const Segment& segment) { return segment.on_curve; });
  }

  bool is_on() const { return settings_.on || has_curves_; }
  /// The curves within segments [first, last), which have no stop between them, in order. Throws Cancelled
  /// when stopped; `progress` may be null.
  std::vector<SmoothCurve> compress(std::size_t first, std::size_t last, const Progress* progress = nullptr);

 private:
  /// The polyline through the points of a run, or along its arcs.
  void set_polyline(const SmoothingRun& run);
  /// Adds the curve of a run, or to `corners` the junctions at which it must be parted.
  void lay(const SmoothingRun& run, std::vector<SmoothCurve>& curves, std::vector<std::size_t>& corners,
           const Progress* progress);

  const Toolpath& toolpath_;
  const PathRules& rules_;
  CompressorSettings settings_;
  bool has_curves_ = false;  ///< of the program
  Polyline polyline_;
  std::vector<std::size_t> segments_;  ///< under each line of the polyline
  CourseSmoother smoother_;
};

}  // namespace feedscope
