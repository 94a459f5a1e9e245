#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace feedscope {

/// Figures of one run, from comparison_json and study_json.
struct MergedRun {
  std::string machine;   ///< id
  std::string model;     ///< id
  std::string setting;   ///< "tolerance=0.02 X.jerk=20"; sweeps or tolerance: "tolerance=program" if that of
                         ///< the program is in force
  std::string key;       ///< common to all runs with the same setting
  bool refused = false;  ///< by the control: no feed motion of the program is run, and there are no figures
  std::size_t lines_not_run = 0;     ///< refused by the control
  double cycle_time = 0;             ///< [s]
  double mean_feed = 0;              ///< [mm/min]
  double max_contour_error = 0;      ///< [mm]
  double cutting_contour_error = 0;  ///< of feed motions, to which a bound applies [mm]
};

struct MergedProgram {
  std::string file;          ///< of the program
  std::size_t errors = 0;    ///< of the program; with errors, its figures are those of a part of it
  std::size_t segments = 0;  ///< 0: no motion, and its figures are 0
  std::vector<MergedRun> runs;
};

/// All programs with one setting.
struct MergedSum {
  MergedRun run;             ///< sum of cycle times, largest contour error, no mean feed; refused if all are
  std::size_t programs = 0;  ///< number of programs run
};

struct MergedComparison {
  std::vector<MergedProgram> programs;
  std::vector<MergedSum> sums;   ///< in the order of their first run
  std::optional<double> within;  ///< bound of the contour error [mm]: as requested, else common to all files

  /// Whether a run is within the bound; true without one, never for a refused run.
  bool keeps(const MergedRun& run) const;
  /// Whether each run of a program with motion is the fastest within the bound, and whether each sum over all
  /// programs is: all fastest_runs(). None if no run is within the bound, or without a bound.
  std::vector<bool> fastest(const MergedProgram& program) const;
  std::vector<bool> fastest_sums() const;
  /// First of fastest_sums().
  const MergedSum* fastest_sum() const;
};

/// Name and contents of a file.
struct NamedText {
  std::string name;
  std::string text;
};

/// Reads output of `compare --json`, one program each. Runs of two programs have the same setting if machine,
/// axis limits, model and settings agree. Throws InputError with file and key: invalid JSON (with its place),
/// a number beyond double, lists nested beyond 64 levels, a key that is missing or of the wrong kind, a
/// duplicate program or setting. `within` [mm]: bound of the contour error; default: the common bound of all
/// files.
MergedComparison merge_comparisons(const std::vector<NamedText>& files, std::optional<double> within = {});

/// Name of the rows over all programs in tables.
inline constexpr const char* all_programs = "all programs";

/// CSV with the columns
/// program,machine,model,setting,programs,cycle_time_s,mean_feed_mm_min,max_contour_error_mm,errors,segments,
/// within_bound,fastest: a row per run, then one per setting over all programs (program: all_programs), with
/// the sums of errors and segments. within_bound and fastest are 0 or 1, empty without a bound.
std::string merged_csv(const MergedComparison& merged);
/// JSON: programs[{file, errors, segments, runs[{machine, model, setting, cycle_time_s, mean_feed_mm_min,
/// max_contour_error_mm, within_bound, fastest}]}], sums[{machine, model, setting, programs, cycle_time_s,
/// max_contour_error_mm, within_bound, fastest}], within_mm; the last three null without a bound.
std::string merged_json(const MergedComparison& merged);

}  // namespace feedscope
