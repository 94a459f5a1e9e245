#include "core/compressor/compressor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/program/path/parametric_curve.h"

namespace feedscope {

const std::vector<SettingSpec>& compressor_settings() {
  static const std::vector<SettingSpec> specs = [] {
    SettingSpec compressor{
        .key = "compressor",
        .title = QT_TRANSLATE_NOOP("core", "Compressor"),
        .explanation = QT_TRANSLATE_NOOP(
            "core",
            "Lays a smooth curve through dense short blocks within the contour tolerance, in place of a "
            "blend in "
            "every corner. program: where the program asks for it (COMPON, COMPCURV, COMPCAD, COMPSURF, "
            "CYCLE832, "
            "cycle 32, G05.1 Q1); off: never; on: everywhere. Our own curve: no maker publishes theirs."),
        .choices = {QT_TRANSLATE_NOOP("core", "program"), QT_TRANSLATE_NOOP("core", "off"),
                    QT_TRANSLATE_NOOP("core", "on")},
    };
    SettingSpec block{
        .key = "compressor_block_mm",
        .title = QT_TRANSLATE_NOOP("core", "Longest compressed block"),
        .unit = "mm",
        .explanation = QT_TRANSLATE_NOOP(
            "core", "Longer lines stay lines; 20 is the value of a Sinumerik (MD20170) when it is new."),
        .maximum = 1000,
        .minimum_allowed = false,
        .fallback = 20,
    };
    SettingSpec angle{
        .key = "compressor_angle_deg",
        .title = QT_TRANSLATE_NOOP("core", "Sharpest smoothed corner"),
        .unit = "deg",
        .explanation = QT_TRANSLATE_NOOP("core",
                                         "Corners that turn by more stay corners; 36 is the value of a "
                                         "Sinumerik (SD42470) when it is new."),
        .maximum = 89,
        .fallback = 36,
    };
    SettingSpec smoothing{
        .key = "compressor_smoothing",
        .title = QT_TRANSLATE_NOOP("core", "Compressor smoothing"),
        .explanation = QT_TRANSLATE_NOOP("core",
                                         "How much waves of the points are damped, in spans of the curve; 0: "
                                         "only by the length of its spans. "
                                         "Assumed: no maker gives a number."),
        .maximum = 2,
    };
    return std::vector<SettingSpec>{compressor, block, angle, smoothing};
  }();
  return specs;
}

std::vector<SettingSpec> with_compressor(std::vector<SettingSpec> own) {
  own.insert(own.end(), compressor_settings().begin(), compressor_settings().end());
  return own;
}

CompressorSettings::CompressorSettings(const Settings& settings)
    : on(settings.text("compressor") != "off"),
      rule{settings.number("compressor_block_mm"), units::from_deg(settings.number("compressor_angle_deg")),
           settings.text("compressor") == "on"},
      smoothing(settings.number("compressor_smoothing")) {}

bool CompressorSettings::smooths(const Toolpath& toolpath) const {
  return on &&
         (rule.everywhere || std::ranges::any_of(toolpath.path_controls, [](const PathControl& control) {
            return control.compressor == Switch::on;
          }));
}

std::vector<SmoothCurve> Compressor::compress(std::size_t first, std::size_t last, const Progress* progress) {
  std::vector<SmoothCurve> curves;
  if (!is_on()) {
    return curves;
  }
  constexpr int max_tries = 3;
  std::vector<std::size_t> corners;
  for (int tries = 0; tries < max_tries; ++tries) {
    curves.clear();
    std::vector<std::size_t> more;
    for (const SmoothingRun& run :
         find_smoothing_runs(toolpath_, first, last, rules_, settings_.rule, corners)) {
      lay(run, curves, more, progress);
    }
    if (more.empty()) {
      break;
    }
    corners.insert(corners.end(), more.begin(), more.end());
    std::sort(corners.begin(), corners.end());
  }
  return curves;
}

void Compressor::set_polyline(const SmoothingRun& run) {
  constexpr double chord_error = 0.1 * curve_tolerance;
  polyline_.clear();
  segments_.clear();
  polyline_.add(toolpath_.start_of(run.first) + run.begin * toolpath_.tangent_at_start(run.first));
  for (std::size_t i = run.first; i <= run.last; ++i) {
    const Segment& segment = toolpath_.segments[i];
    if (segment.kind == SegmentKind::arc) {
      const Arc& arc = toolpath_.arc_of(segment);
      const double longest = std::sqrt(8 * chord_error / arc.curvature());
      const int chords = static_cast<int>(std::ceil(segment.length / longest));
      for (int k = 1; k < chords; ++k) {
        polyline_.add(arc.at(segment.length * k / chords).position);
        segments_.push_back(i);
      }
    }
    const bool cut = i == run.last && run.end < segment.length;
    polyline_.add(cut ? Vec3(toolpath_.start_of(i) + run.end * toolpath_.tangent_at_start(i)) : segment.end);
    segments_.push_back(i);
  }
  polyline_.start_direction = toolpath_.tangent_at_start(run.first);
  polyline_.end_direction = toolpath_.tangent_at_end(run.last);
  polyline_.free_start = run.from_rest;
  polyline_.free_end = run.to_rest;
}

void Compressor::lay(const SmoothingRun& run, std::vector<SmoothCurve>& curves,
                     std::vector<std::size_t>& corners, const Progress* progress) {
  set_polyline(run);
  SmoothingRule rule{curve_tolerance, settings_.smoothing};
  if (!run.on_curve) {
    rule.tolerance = std::numeric_limits<double>::infinity();
    for (std::size_t i = run.first; i < run.last; ++i) {
      rule.tolerance = std::min(rule.tolerance, rules_.corner_tolerance(i));
    }
    rule.tolerance *= settings_.tolerance_share;
  }
  SmoothCourse course = smoother_.smooth(polyline_, rule, progress);
  for (const std::size_t point : course.corners) {
    if (!run.on_curve) {  // otherwise it remains arcs
      corners.push_back(segments_[point]);
    }
  }
  if (!course.knots.empty()) {
    SmoothCurve& curve = curves.emplace_back();
    curve.run = run;
    curve.knots = std::move(course.knots);
    curve.tolerance = rule.tolerance;
    curve.blocks.reserve(course.lines.size());
    for (const std::size_t line : course.lines) {
      curve.blocks.push_back(static_cast<std::uint32_t>(segments_[line]));
    }
  }
}

}  // namespace feedscope
