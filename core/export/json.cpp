
#include <numeric>

#include "core/analysis/contour/contour_histogram.h"
#include "core/analysis/contour/contour_report.h"
#include "core/analysis/notes/not_counted.h"
#include "core/analysis/notes/slower_tolerance.h"
#include "core/analysis/notes/tolerance_effect.h"
#include "core/analysis/run/program_facts.h"
#include "core/analysis/study/recommendation.h"
#include "core/base/units.h"
#include "core/export/contour_words.h"
#include "core/export/export.h"
#include "core/export/json_parts.h"

namespace feedscope {
namespace {

/// A measured distance from the programmed path [mm].
Json rounded_length(double value) {
  return finite(rounded_error(value));
}

Json vector(const Vec3& v) {
  return Json::array({finite(v.x()), finite(v.y()), finite(v.z())});
}

Json bounds(const Bounds& box) {
  return {{"min", vector(box.min)}, {"max", vector(box.max)}};
}

Json unit_json(const ProgramUnit& unit) {
  using Source = ProgramUnit::Source;
  return {{"name", to_string(unit.unit)},
          {"said_by", unit.source == Source::program ? "program"
                      : unit.source == Source::asked ? "option"
                                                     : "nobody"}};
}

Json diagnostics(const std::vector<Diagnostic>& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics) {
    Json entry{{"severity", to_string(d.severity)},
               {"line", d.line},
               {"column", d.column},
               {"code", d.code},
               {"message", d.message.english()},
               {"hint", d.hint.english()}};
    if (!d.file.empty()) {
      entry["file"] = d.file;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Json tools(const Program& program) {
  Json list = Json::array();
  for (const ToolChange& tool : program.tools) {
    list.push_back({{"name", tool.name}, {"line", tool.line}});
  }
  return list;
}

Json cutters(const Program& program) {
  Json list = Json::array();
  for (const CutterUse& use : program.cutters) {
    const bool known = use.source != CutterSource::unknown;
    list.push_back({{"tool", use.tool},
                    {"radius_mm", known ? Json(use.radius) : Json(nullptr)},
                    {"source", to_string(use.source)},
                    {"line", use.line}});
  }
  return list;
}

Json work_offsets(const Program& program) {
  Json list = Json::array();
  for (const OffsetUse& use : program.work_offsets) {
    list.push_back({{"name", use.name}, {"line", use.line}, {"motions", use.blocks}, {"given", use.given}});
  }
  return list;
}

Json path_control(const ProgramFacts& facts) {
  const auto optional = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  Json list = Json::array();
  for (const PathControlRange& range : facts.path_control) {
    const std::string_view window = to_string(range.control.exact_stop_window);
    const std::optional<double>& orientation = range.control.orientation_tolerance;
    list.push_back({{"first_line", range.first_line},
                    {"last_line", range.last_line},
                    {"exact_stop", range.control.mode == PathMode::exact_stop},
                    {"exact_stop_window", window.empty() ? Json() : Json(window)},
                    {"contour_tolerance_mm", optional(range.control.contour_tolerance)},
                    {"blend_distance_mm", optional(range.control.blend_distance)},
                    {"orientation_tolerance_deg", orientation ? Json(units::to_deg(*orientation)) : Json()},
                    {"text", describe(range.control).english()}});
  }
  return list;
}

Json not_counted_json(const NotCounted& counts) {
  Json list = Json::array();
  for (const NotCountedItem& item : not_counted_items(counts)) {
    list.push_back({{"what", item.key}, {"count", item.count}, {"settings", item.settings}});
  }
  return list;
}

/// The same keys for all commands.
Json program_json(const Program& program, const Toolpath& toolpath) {
  const ProgramFacts facts = facts_of(program, toolpath);
  return {{"file", program.source->name()},
          {"lines", facts.lines},
          {"dialect", info_of(program.dialect).id},
          {"unit", unit_json(program.unit)},
          {"blocks", facts.blocks},
          {"segments", facts.segments},
          {"arcs", facts.arcs},
          {"dwells", facts.dwells},
          {"path_mm", finite(facts.path_length)},
          {"rapid_mm", finite(facts.rapid_length)},
          {"dwell_s", finite(facts.dwell_time)},
          {"feed_mm_min",
           {{"min", finite(units::to_mm_min(facts.min_feed))},
            {"max", finite(units::to_mm_min(facts.largest_feed))}}},
          {"chord_error_mm", facts.chord_error ? Json(facts.chord_error->value) : Json()},
          {"chord_error_lines", facts.chord_error ? facts.chord_error->chords : 0},
          {"tools", tools(program)},
          {"cutters", cutters(program)},
          {"work_offsets", work_offsets(program)},
          {"calls", program.call_count},
          {"not_counted", not_counted_json(facts.not_counted)},
          {"path_control", path_control(facts)},
          {"bounds", bounds(facts.bounds)},
          {"cutting_bounds", bounds(facts.cutting_bounds)},
          {"rapid_bounds", bounds(facts.rapid_bounds)}};
}

/// [mm/s, mm/s2, mm/s3]
Json axis_figures(double velocity, double acceleration, double jerk) {
  return {{"velocity_mm_min", finite(units::to_mm_min(velocity))},
          {"acceleration_m_s2", finite(units::to_m(acceleration))},
          {"jerk_m_s3", finite(units::to_m(jerk))}};
}

Json peaks(const Summary& summary) {
  Json axes = Json::object();
  for (std::size_t i = 0; i < summary.axes.size(); ++i) {
    const AxisPeaks& axis = summary.axes[i];
    axes[std::string(1, summary.axes.name(i))] = axis_figures(axis.velocity, axis.acceleration, axis.jerk);
  }
  Json json{{"feed_mm_min", finite(units::to_mm_min(summary.peak_feed))}, {"axes", axes}};
  for (std::size_t i = 0; summary.rotary && i < rotary_names.size(); ++i) {
    const AxisPeaks& axis = summary.rotary->rotary[i];
    if (!std::isnan(axis.velocity)) {
      json["rotary_axes"][std::string(1, rotary_names[i])] = {
          {"velocity_rev_min", finite(units::to_turns_min(axis.velocity))},
          {"acceleration_rev_s2", finite(units::to_turns(axis.acceleration))},
          {"jerk_rev_s3", finite(units::to_turns(axis.jerk))}};
    }
  }
  for (std::size_t i = 0; summary.rotary && summary.rotary->linear && i < coordinate_names.size(); ++i) {
    const AxisPeaks& axis = (*summary.rotary->linear)[i];
    json["machine_axes"][std::string(1, coordinate_names[i])] =
        axis_figures(axis.velocity, axis.acceleration, axis.jerk);
  }
  if (summary.rotary) {
    const OrientationError& error = summary.rotary->orientation;
    json["orientation_error"] = {{"deg", finite(units::to_deg(error.angle))},
                                 {"line", error.line > 0 ? Json(error.line) : Json()}};
  }
  return json;
}

/// Null for a run that never leaves the programmed path.
Json contour_place(const Summary& summary) {
  if (!(summary.max_contour_error > 0)) {
    return nullptr;
  }
  const ContourPlace& place = summary.worst_place;
  return {{"line", place.line},
          {"time_s", finite(place.time)},
          {"position_mm", vector(place.position)},
          {"side_mm", rounded_length(place.side)}};
}

/// `seconds` in the order of cause_index(); causes without time are omitted.
Json by_cause(const std::vector<double>& seconds) {
  Json times = Json::object();
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (seconds[i] > 0) {
      times[cause_key(all_causes()[i])] = seconds[i];
    }
  }
  return times;
}

/// Null for a run that follows no tolerance.
Json tolerance_json(const std::optional<ToleranceInForce>& tolerance) {
  return tolerance ? Json{{"min", tolerance->min}, {"max", tolerance->max}} : Json();
}

Json axis_limits(const Machine& machine) {
  Json axes = Json::object();
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const AxisLimits& axis = machine.axes[i];
    axes[std::string(1, machine.axes.name(i))] = axis_figures(axis.velocity, axis.acceleration, axis.jerk);
  }
  return axes;
}

/// Limits and travel of the rotary axes; null for an axis that turns without end.
Json rotary_limits(const Machine& machine) {
  Json axes = Json::object();
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    const auto degrees = [](const std::optional<double>& end) {
      return end ? Json(units::to_deg(*end)) : Json();
    };
    axes[std::string(1, axis.name)] = {{"velocity_rev_min", finite(units::to_turns_min(axis.velocity))},
                                       {"acceleration_rev_s2", finite(units::to_turns(axis.acceleration))},
                                       {"jerk_rev_s3", finite(units::to_turns(axis.jerk))},
                                       {"minimum_deg", degrees(axis.minimum)},
                                       {"maximum_deg", degrees(axis.maximum)}};
  }
  return axes;
}

/// Limits of a machine; rotary ones only if it has rotary axes.
Json machine_limits(const Machine& machine) {
  Json limits{{"axes", axis_limits(machine)}};
  if (!machine.kinematics.empty()) {
    limits["rotary_axes"] = rotary_limits(machine);
  }
  return limits;
}

/// Null if all axes follow their set values exactly.
Json actual_json(const Summary& summary) {
  if (!summary.actual) {
    return nullptr;
  }
  const ActualFigures& actual = *summary.actual;
  Json following = Json::object();
  for (std::size_t i = 0; i < coordinate_names.size(); ++i) {
    following[std::string(1, coordinate_names[i])] =
        finite(units::to_um(actual.largest_following_error[static_cast<Eigen::Index>(i)]));
  }
  return {{"max_following_error_um", following},
          {"max_contour_error_mm", rounded_length(actual.worst.error)},
          {"mean_contour_error_mm", rounded_length(actual.mean_contour_error)},
          {"max_contour_error_at",
           {{"line", actual.worst.line},
            {"time_s", finite(actual.worst.time)},
            {"position_mm", vector(actual.worst.position)},
            {"of_control_mm", rounded_length(actual.worst.of_control)}}}};
}

/// The remarks on a run but for `not_counted`, which has a key of its own.
std::vector<std::string> notes_of(const ComparedRun& run) {
  std::vector<std::string> notes;
  for (const Remark& remark : run.remarks) {
    if (remark.about != Remark::About::not_counted) {
      notes.push_back(remark.text.english());
    }
  }
  return notes;
}

/// Setup and results of a run: the same keys for all commands, null for times, feeds and errors of a run
/// without `figures`.
Json run_json(const ComparedRun& run, bool figures) {
  const Machine& machine = run.setup.machine;
  const ModelInfo& model = run.setup.model->info();
  const Summary& summary = run.summary;
  const auto figure = [&](const Json& value) { return figures ? value : Json(); };
  return {{"machine", {{"id", machine.id}, {"name", machine.name}, {"control", machine.control}}},
          {"model", {{"id", model.id}, {"title", model.title}, {"reference", model.reference}}},
          {"settings", settings_values(run.setup.settings)},
          {"limits", machine_limits(machine)},
          {"tolerance_in_force_mm", tolerance_json(run.tolerance)},
          {"tolerance_set_by", run.tolerance ? Json(to_string(run.tolerance->set_by)) : Json()},
          {"notes", notes_of(run)},
          {"lines_not_run", run.lines_not_run},
          {"out_of_reach", run.out_of_reach},
          {"cycle_time_s", figure(finite(summary.cycle_time))},
          {"programmed_time_s", figure(finite(summary.programmed_time))},
          {"against_cam", figure(finite(run.against_cam()))},
          {"mean_feed_mm_min", figure(finite(units::to_mm_min(summary.mean_feed)))},
          {"path_mm", finite(run.path_length)},
          {"blends", run.blends},
          {"max_contour_error_mm", figure(rounded_length(summary.max_contour_error))},
          {"max_contour_error_cutting_mm", figure(rounded_length(summary.cutting_contour_error))},
          {"max_corner_distance_mm", figure(rounded_length(summary.max_corner_distance))},
          {"max_contour_error_at", contour_place(summary)},
          {"peaks", peaks(summary)},
          {"time_by_cause_s", by_cause(summary.time_by_cause)},
          {"ramp_down_by_slower_place_s", by_cause(summary.time_by_slower_place)},
          {"not_counted", not_counted_json(summary.not_counted)},
          {"drives", drives_json(machine)},
          {"actual", actual_json(summary)},
          {"load", load_json(run)}};
}

Json place_json(const ContourFinding& finding) {
  const ContourPlace& place = finding.place;
  const ContourSpot& spot = finding.spot;
  Json json{{"line", place.line}};
  if (!finding.block.empty()) {
    json["block"] = finding.block;
  }
  json["time_s"] = place.time;
  json["path_mm"] = place.path_length;
  json["error_mm"] = rounded_length(place.error);
  json["side_mm"] = place.side;
  if (finding.tolerance) {
    json["tolerance_mm"] = *finding.tolerance;
  }
  json["at"] = contour_word(spot.kind);
  json["length_mm"] = spot.length;
  if (spot.kind == ContourSpot::Kind::corner) {
    json["turn_deg"] = units::to_deg(spot.turn);
  }
  if (spot.kind == ContourSpot::Kind::arc) {
    json["radius_mm"] = spot.radius;
  }
  if (spot.kind != ContourSpot::Kind::line) {
    json["inside"] = spot.inside;
  }
  json["position_mm"] = vector(place.position);
  json["programmed_mm"] = vector(place.programmed);
  json["feed_mm_min"] = units::to_mm_min(finding.feed);
  json["programmed_feed_mm_min"] = units::to_mm_min(finding.programmed_feed);
  json["cause"] = cause_key(finding.cause);
  return json;
}

Json histogram_json(const ContourReport& report, ContourBins bins) {
  const ContourHistogram histogram = histogram_of(report.spread, bins, report.largest);
  return {{"edges_mm", histogram.edges}, {"length_mm", histogram.length}};
}

Json contour_json(const ContourReport& report) {
  Json places = Json::array();
  for (const ContourFinding& finding : report.worst) {
    places.push_back(place_json(finding));
  }
  return {{"contour_places", std::move(places)},
          {"contour_histogram",
           {{"distance", histogram_json(report, ContourBins::amounts)},
            {"side", histogram_json(report, ContourBins::sides)}}}};
}

/// Messages of the reader, then `others`.
Json messages_json(const Program& program, const std::vector<Diagnostic>& others) {
  std::vector<Diagnostic> all = program.diagnostics;
  all.insert(all.end(), others.begin(), others.end());
  return diagnostics(all);
}

}  // namespace

Json run_head_json(const Run& run, const ComparedRun& figures) {
  Json json{{"program", program_json(*run.input.program, *run.input.toolpath)}};
  json.update(run_json(figures, !figures.refused));
  return json;
}

Json run_end_json(const Run& run, const ComparedRun& figures) {
  return {{"diagnostics", messages_json(*run.input.program, run.lines_not_run)},
          {"elapsed", {{"read_s", run.input.read_time}, {"simulate_s", figures.simulate_time}}}};
}

std::string simulation_json(const Run& run, const ComparedRun& figures, const ContourReport* contour) {
  Json json = with_format("simulation");
  json.update(run_head_json(run, figures));
  if (contour != nullptr) {
    json.update(contour_json(*contour));
  }
  json.update(run_end_json(run, figures));
  return text_of(json);
}

namespace {

/// `runs`: from run_json().
Json with_runs(const char* kind, const LoadedProgram& program, Json runs) {
  Json json = with_format(kind);
  json["program"] = program_json(*program.program, *program.toolpath);
  json["runs"] = std::move(runs);
  json["diagnostics"] = diagnostics(program.program->diagnostics);
  return json;
}

Json elapsed_json(const LoadedProgram& program, const std::vector<double>& of_runs) {
  return {{"read_s", program.read_time},
          {"simulate_s", std::accumulate(of_runs.begin(), of_runs.end(), 0.0)},
          {"runs_s", of_runs}};
}

Json operations_json(const Study& study, const StudyRun& run) {
  Json list = Json::array();
  for (std::size_t i = 0; i < run.operations.size(); ++i) {
    const OperationFigures& figures = run.operations[i];
    list.push_back({{"title", study.operations[i].title},
                    {"line", study.operations[i].line},
                    {"time_s", finite(figures.time)},
                    {"cutting_length_mm", finite(figures.cutting_length)},
                    {"mean_feed_mm_min", finite(units::to_mm_min(figures.mean_feed()))},
                    {"max_contour_error_mm", rounded_length(figures.contour_error)},
                    {"max_contour_error_cutting_mm", rounded_length(figures.cutting_contour_error)},
                    {"limiting_cause", cause_key(figures.cause)},
                    {"limiting_time_s", finite(figures.cause_time)}});
  }
  return list;
}

/// `run` and `against`: indices into the list of runs.
Json slower_json(std::span<const ToleranceRun> runs) {
  Json list = Json::array();
  for (const SlowerTolerance& slower : slower_with_wider_tolerance(runs)) {
    list.push_back({{"run", slower.wide},
                    {"against", slower.narrow},
                    {"tolerance_mm", finite(slower.wide_value)},
                    {"against_tolerance_mm", finite(slower.narrow_value)},
                    {"more_s", finite(slower.more)},
                    {"cause", cause_key(slower.cause)},
                    {"cause_more_s", finite(slower.cause_more)},
                    {"why", why_slower(slower)}});
  }
  return list;
}

/// `run` and `against`: indices into the list of runs; null without a recommendation.
Json recommendation_json(std::span<const ComparedRun> runs, std::optional<double> within) {
  const std::optional<Recommendation> taken = recommend(runs, within);
  if (!taken) {
    return nullptr;
  }
  return {{"run", taken->run},
          {"reason", to_string(taken->reason)},
          {"against", taken->against},
          {"gain_s", finite(taken->gain)},
          {"gain_percent", finite(100 * taken->gain_share)},
          {"max_contour_error_mm", rounded_length(taken->contour_error)}};
}

Json limits_json(const StudyRun& run) {
  Json causes = Json::object();
  for (const CauseShare& cause : limiting_causes(run.summary)) {
    causes[cause_key(cause.cause)] = finite(cause.share);
  }
  return causes;
}

}  // namespace

std::string comparison_json(const LoadedProgram& program, std::span<const ComparedRun> runs) {
  Json list = Json::array();
  std::vector<double> times;
  for (const ComparedRun& run : runs) {
    list.push_back(run_json(run, run.is_possible()));
    times.push_back(run.simulate_time);
  }
  Json json = with_runs("comparison", program, std::move(list));
  json["recommendation"] = recommendation_json(runs, std::nullopt);
  json["slower_with_wider_tolerance"] = slower_json(tolerance_runs(runs));
  json["elapsed"] = elapsed_json(program, times);
  return text_of(json);
}

std::string study_json(const LoadedProgram& program, const Study& study) {
  Json list = Json::array();
  std::vector<double> times;
  for (const auto& curve : study.curves()) {
    const std::vector<bool> marks = fastest_marks(curve, study.within);
    for (std::size_t at = 0; at < curve.size(); ++at) {
      const StudyRun& run = curve[at];
      Json json = run_json(run, run.is_possible());
      Json swept = Json::object();
      for (std::size_t i = 0; i < study.sweeps.size(); ++i) {
        swept[study.sweeps[i].key] = run.swept[i];
      }
      json["swept"] = std::move(swept);
      json["fastest"] = static_cast<bool>(marks[at]);
      json["limiting_share"] = limits_json(run);
      if (!study.operations.empty()) {
        json["operations"] = operations_json(study, run);
      }
      list.push_back(std::move(json));
      times.push_back(run.simulate_time);
    }
  }
  Json json = with_runs("study", program, std::move(list));
  Json sweeps = Json::array();
  for (const Sweep& sweep : study.sweeps) {
    sweeps.push_back({{"key", sweep.key}, {"unit", sweep_unit(sweep.key)}, {"values", sweep.values}});
  }
  json["sweeps"] = std::move(sweeps);
  json["within_mm"] = study.within ? Json(*study.within) : Json(nullptr);
  json["recommendation"] =
      recommendation_json(std::vector<ComparedRun>(study.runs.begin(), study.runs.end()), study.within);
  std::vector<ToleranceRun> tolerances;
  for (const StudyRun& run : study.runs) {
    tolerances.push_back({&run.setup, &run.summary});
  }
  json["slower_with_wider_tolerance"] = slower_json(tolerances);
  json["elapsed"] = elapsed_json(program, times);
  return text_of(json);
}

std::string check_json(const LoadedProgram& program, const MachinePath& path) {
  Json json = with_format("check");
  json["program"] = program_json(*program.program, *path);
  json["diagnostics"] = messages_json(*program.program, path.faults);
  json["elapsed"] = {{"read_s", program.read_time}};
  return text_of(json);
}

}  // namespace feedscope
