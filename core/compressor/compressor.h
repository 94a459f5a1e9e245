#pragma once

// Room `compressor`: dense short lines to smooth curves within the contour tolerance. smoothing_run.h finds
// runs of blocks, cubic_spline_fit.h lays a curve through them, Compressor gives the curves to the room
// `blend`.

#include <algorithm>
#include <vector>

#include "core/base/progress.h"
#include "core/compressor/smooth_course.h"
#include "core/compressor/smoothing_run.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Settings of the compressor in internal units.
struct CompressorSettings {
  bool on = false;
  CompressorRule rule;
  double smoothing = 0;        ///< as SmoothingRule
  double tolerance_share = 1;  ///< share of the contour tolerance available for curves through blocks

  CompressorSettings() = default;
  explicit CompressorSettings(const Settings& settings);
  /// Whether any block of `toolpath` may be smoothed.
  bool smooths(const Toolpath& toolpath) const;
};

/// Settings for models with a compressor: compressor, compressor_block_mm, compressor_angle_deg,
/// compressor_smoothing.
const std::vector<SettingSpec>& compressor_settings();

/// `own` followed by these settings.
std::vector<SettingSpec> with_compressor(std::vector<SettingSpec> own);

/// A smooth curve that replaces a run of lines.
struct SmoothCurve {
  SmoothingRun run;
  std::vector<CourseKnot> knots;      ///< s from 0; at least two
  std::vector<std::uint32_t> blocks;  ///< segment at each knot except the last
  double tolerance = 0;               ///< permitted distance from the run [mm]
};

/// Fits smooth curves to curves of the program (splines, polynomials) that the reader has converted to
/// tangent arcs, within curve_tolerance, always; and to dense short blocks, if on, like compressors and
/// spline functions of controls. No control's curve is published: this one is our own, consistent with the
/// makers' descriptions (README.md next to this file).
class Compressor {
 public:
  /// `toolpath` and `rules` outlive this.
  Compressor(const Toolpath& toolpath, const PathRules& rules, const CompressorSettings& settings)
      : toolpath_(toolpath), rules_(rules), settings_(settings) {
    settings_.rule.lines = settings.on;
    has_curves_ = std::any_of(toolpath.segments.begin(), toolpath.segments.end(),
                              [](const Segment& segment) { return segment.on_curve; });
  }

  bool is_on() const { return settings_.on || has_curves_; }
  /// Curves within segments [first, last), which have no stop in between, in order. Throws Cancelled when
  /// stopped; `progress` may be null.
  std::vector<SmoothCurve> compress(std::size_t first, std::size_t last, const Progress* progress = nullptr);

 private:
  /// Sets the polyline through the points of a run, or along its arcs.
  void set_polyline(const SmoothingRun& run);
  /// Adds the curve of a run, or adds to `corners` the junctions at which it must be divided.
  void lay(const SmoothingRun& run, std::vector<SmoothCurve>& curves, std::vector<std::size_t>& corners,
           const Progress* progress);

  const Toolpath& toolpath_;
  const PathRules& rules_;
  CompressorSettings settings_;
  bool has_curves_ = false;  ///< in the program
  Polyline polyline_;
  std::vector<std::size_t> segments_;  ///< for each line of the polyline
  CourseSmoother smoother_;
};

}  // namespace feedscope
