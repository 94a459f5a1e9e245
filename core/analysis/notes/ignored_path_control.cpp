#include "core/analysis/notes/ignored_path_control.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace feedscope {

namespace {

/// Data that the rules examine: a path control of the program, the guarantees of the model, and the setup.
struct Asked {
  const PathControl& control;
  const Guarantees& promised;
  const Setup& setup;

  /// Without ramps there is no acceleration to select.
  bool has_ramps() const { return promised.continuity != Continuity::position; }
};

struct Rule {
  Translatable sentence;
  bool (*is_ignored)(const Asked& asked);
};

constexpr auto rules = std::to_array<Rule>({
    {NC_("core", "Tolerances and blend distances of the program are not used: the model has no blends."),
     [](const Asked& a) {
       return (a.control.contour_tolerance || a.control.blend_distance) && !contour_tolerance(a.setup) &&
              !a.promised.own_tolerances;
     }},
    {NC_("core", "Compaction requested by the program is not simulated: short blocks are not joined."),
     [](const Asked& a) {
       const bool everywhere =
           a.setup.settings.has("compressor") && a.setup.settings.text("compressor") == "on";
       const bool smooths = a.promised.smooths && (everywhere || a.control.compressor == Switch::on);
       return a.control.compaction == Switch::on && !smooths && !a.promised.follows_compaction;
     }},
    {NC_("core", "BRISK of the program is not simulated: the jerk along the path stays limited."),
     [](const Asked& a) {
       return a.control.acceleration == AccelerationMode::brisk && a.has_ramps() && !a.promised.follows_brisk;
     }},
    {NC_("core",
         "DRIVE of the program is simulated as SOFT: the speed above which it reduces the acceleration is in "
         "the machine data of the control."),
     [](const Asked& a) { return a.control.acceleration == AccelerationMode::drive && a.has_ramps(); }},
    {NC_("core",
         "Feed-forward switched off by the program is not simulated: the axes are assumed to follow without "
         "lag."),
     [](const Asked& a) { return a.control.feed_forward == Switch::off; }},
    {NC_("core", "Look-ahead switched off by the program is not simulated."),
     [](const Asked& a) { return a.control.look_ahead == Switch::off && a.has_ramps(); }},
});

/// Times of splines as arcs over those on the curves of continuous curvature that they approximate: 2 to 2.4.
constexpr Translatable curves_as_arcs = NC_(
    "core",
    "Curves of the program are simulated as tangent arcs: where the curvature jumps, a control that limits "
    "the jerk slows down, and the time shown is up to 2.4 times that on the curve itself.");

/// Accelerations, jerks and filters selected by a number.
constexpr Translatable machining_modes = NC_(
    "core",
    "The machining mode of the program (type of CYCLE832, HSC-MODE, P of G187, R of G5.1) changes nothing: "
    "what it selects exists only in the control. Compare modes by acceleration and jerk of the machine.");

bool is_said(const LoadedProgram& program, std::string_view code) {
  const std::vector<Diagnostic>& said = program.program->diagnostics;
  return std::any_of(said.begin(), said.end(), [&](const Diagnostic& d) { return d.code == code; });
}

}  // namespace

std::vector<Message> ignored_path_control(const LoadedProgram& program, const Setup& setup) {
  std::vector<Message> sentences = ignored_path_control(*program.toolpath, setup);
  const Guarantees promised = setup.model->guarantees(setup.settings);
  const bool has_ramps = promised.continuity != Continuity::position;
  const bool limits_jerk = has_ramps && !setup.model->info().jumps_in_corners;
  if (limits_jerk && !promised.lays_curves && is_said(program, "curve-as-arcs")) {
    sentences.emplace_back(curves_as_arcs);
  }
  if (has_ramps && is_said(program, "machining-mode")) {
    sentences.emplace_back(machining_modes);
  }
  return sentences;
}

std::vector<Message> ignored_path_control(const Toolpath& toolpath, const Setup& setup) {
  const Guarantees promised = setup.model->guarantees(setup.settings);
  std::vector<Message> sentences;
  for (const Rule& rule : rules) {
    const bool applies = std::any_of(toolpath.path_controls.begin(), toolpath.path_controls.end(),
                                     [&](const PathControl& control) {
                                       return rule.is_ignored({control, promised, setup});
                                     });
    if (applies) {
      sentences.emplace_back(rule.sentence);
    }
  }
  return sentences;
}

}  // namespace feedscope
