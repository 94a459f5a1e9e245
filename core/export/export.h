#pragma once

// Room `export`: CSV and JSON, the only files with stable columns and keys. README.md in this folder lists
// every one.

#include <iosfwd>
#include <span>
#include <string>

#include "core/analysis/study/compare.h"
#include "core/analysis/study/study.h"

namespace feedscope {

struct ContourReport;
struct ProgramDifference;
struct TimeReport;

/// Samples as CSV, columns as in README.md next to this file; one row every `step` [s] and one at the very
/// end. `sources`: of the trajectory's run, with columns after those of the motion; those of the cutting load
/// are empty without a cut.
void write_csv(std::ostream& out, const Trajectory& trajectory, double step, Progress* progress = nullptr,
               const RunSources& sources = {});
/// As CSV with a row at each of `times` [s], ascending, clamped to the run.
void write_csv(std::ostream& out, const Trajectory& trajectory, std::span<const double> times,
               Progress* progress = nullptr, const RunSources& sources = {});
/// Corner blends as CSV, columns as in README.md next to this file.
void write_blends(std::ostream& out, const Trajectory& trajectory, const Progress* progress = nullptr);

// JSON, indented, newline at the end; every key is listed in core/export/README.md. Files of two equal
// commands differ only in `elapsed`.

/// A run with its figures_of(); with a contour report also its places and histogram.
std::string simulation_json(const Run& run, const ComparedRun& figures,
                            const ContourReport* contour = nullptr);
/// A run with its figures_of(), the breakdown of its time and effective changes.
std::string explanation_json(const Run& run, const ComparedRun& figures, const TimeReport& report);
/// Several runs of a program.
std::string comparison_json(const LoadedProgram& program, std::span<const ComparedRun> runs);
/// Results of `check`; `path`: of the program, on the machine that is asked for.
std::string check_json(const LoadedProgram& program, const MachinePath& path);

/// Two programs on one setup, matched by their paths.
std::string program_difference_json(const Run& old, const Run& now, const ProgramDifference& difference);

/// Several runs as CSV, one row each: machine,model,tolerance_mm (in force; empty if the model follows none
/// or the program has several), cycle_time_s,programmed_time_s,against_cam,mean_feed_mm_min,
/// peak_feed_mm_min,max_contour_error_mm,blends,tolerance_min_mm,tolerance_max_mm,tolerance_set_by,
/// max_contour_error_cutting_mm (of feed motions, to which bounds apply), for every axis its peaks
/// (vx_mm_min,ax_m_s2,jx_m_s3) and their share of the limits (vx_share,...), and time_CAUSE_s for every cause
/// of any run. `names`: of the runs, as a last column `run`; empty: no such column.
std::string comparison_csv(std::span<const ComparedRun> runs, std::span<const std::string> names = {});

/// Contents of comparison_json, and the sweeps.
std::string study_json(const LoadedProgram& program, const Study& study);
/// A study as CSV: the columns of comparison_csv, then setting_KEY for every sweep, within_bound (0, 1, empty
/// without a bound), fastest (0, 1), limiting_cause, limiting_share; for a study of operations also
/// operation, operation_line, cutting_length_mm: every run has its own row, in which these are empty, and one
/// for each operation, in which cycle_time_s, mean_feed_mm_min, max_contour_error_mm and limiting_ are those
/// of the operation and the other figures are empty.
std::string study_csv(const Study& study);

}  // namespace feedscope
