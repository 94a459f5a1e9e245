#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "core/analysis/compare.h"
#include "core/analysis/program_facts.h"
#include "core/analysis/study/study.h"
#include "core/analysis/summary.h"
#include "core/machine/machine.h"
#include "core/models/control_model.h"
#include "core/program/program.h"

namespace feedscope {

struct ContourReport;

/// Samples as CSV, columns of DESIGN section 4; one row each `step` [s] and one for the very end.
void write_csv(std::ostream& out, const Trajectory& trajectory, double step, Progress* progress = nullptr);
/// The same with a row at each of `times` [s], ascending, clamped to the run.
void write_csv(std::ostream& out, const Trajectory& trajectory, std::span<const double> times,
               Progress* progress = nullptr);
/// Corner blends as CSV, columns of DESIGN section 4.
void write_blends(std::ostream& out, const Trajectory& trajectory);

/// What write_json reports.
struct Report {
  const Program& program;
  const Toolpath& toolpath;
  const Machine& machine;
  const ModelInfo& model;
  const Settings& settings;
  const Summary& summary;
  double read_time = 0;                    ///< wall clock [s]
  double simulate_time = 0;                ///< wall clock [s]
  const ContourReport* contour = nullptr;  ///< null: its keys are left out
};

/// The run as JSON, keys of DESIGN section 4 and not_counted[{what: tool_change, spindle_start, stop or
/// machine_move, count, settings: keys that would give the time}], indented, newline at the end. With a
/// contour report also contour_places[{line, block, time_s, path_mm, error_mm, side_mm, tolerance_mm, at,
/// length_mm, turn_deg, radius_mm, inside, position_mm[3], programmed_mm[3], feed_mm_min,
/// programmed_feed_mm_min, cause}], keys as contour_places_csv() has columns and absent where those are
/// empty, and contour_histogram{distance{ edges_mm[], length_mm[]}, side{...}}.
std::string simulation_json(const Report& report);

/// Several runs of a program as JSON: program, diagnostics and elapsed{read_s} as in simulation_json, and
/// runs[], each with the keys of simulation_json from machine to time_by_cause_s, then against_cam (cycle
/// time over programmed time), path_mm, blends, limits{axes} with the keys of peaks{axes},
/// elapsed{simulate_s}.
std::string comparison_json(const LoadedProgram& program, std::span<const ComparedRun> runs);
/// Several runs as CSV, one row each: machine,model,tolerance_mm (empty where the model reads none),
/// cycle_time_s,programmed_time_s,against_cam,mean_feed_mm_min,peak_feed_mm_min,max_contour_error_mm,blends,
/// for every axis its peaks (vx_mm_min,ax_m_s2,jx_m_s3) and their share of the limits (vx_share,...), and
/// time_CAUSE_s for every cause that any run has.
std::string comparison_csv(std::span<const ComparedRun> runs);

/// A study as JSON: what comparison_json writes, per run also swept{key: value}, fastest (of its curve,
/// within the bound), limiting_share{cause: share of the cycle time} as limiting_causes(), operations[] where
/// they were asked for, and sweeps[{key, unit, values}], within_mm.
std::string study_json(const LoadedProgram& program, const Study& study);
/// A study as CSV: the columns of comparison_csv, then setting_KEY for every sweep, within_bound (0, 1, empty
/// without a bound), fastest (0, 1), limiting_cause, limiting_share; where operations were asked for also
/// operation, operation_line, cutting_length_mm: every run has a row of its own, in which these are empty,
/// and one for each operation, in which cycle_time_s, mean_feed_mm_min, max_contour_error_mm and limiting_
/// are those of the operation and the other figures are empty.
std::string study_csv(const Study& study);

/// What `check` found as JSON: program{file, lines, blocks, segments, arcs, dwells, path_mm, rapid_mm,
/// dwell_s, feed_mm_min{min, max}, work_offsets[{name, line, motions, given}], not_counted[{what, count,
/// settings}], bounds} and diagnostics as in simulation_json.
std::string check_json(const Program& program, const ProgramFacts& facts);

}  // namespace feedscope
