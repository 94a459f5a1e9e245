#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace feedscope {

/// Figures of one run as comparison_json and study_json write them.
struct MergedRun {
  std::string machine;  ///< id
  std::string model;    ///< id
  std::string setting;  ///< "tolerance=0.02 X.jerk=20"; what was swept, or the tolerance: "tolerance=program"
                        ///< where that of the program is in force
  std::string key;      ///< everything that runs of the same setting share
  bool refused = false;  ///< by the control: no feed motion of the program is run, and there are no figures
  std::size_t lines_not_run = 0;     ///< that the control refuses
  double cycle_time = 0;             ///< [s]
  double mean_feed = 0;              ///< [mm/min]
  double max_contour_error = 0;      ///< [mm]
  double cutting_contour_error = 0;  ///< of feed motions, which a bound holds for [mm]
};

struct MergedProgram {
  std::string file;          ///< of the program
  std::size_t errors = 0;    ///< of the program; where there are some, its figures are those of a part of it
  std::size_t segments = 0;  ///< 0: it moves nothing, and its figures are 0
  std::vector<MergedRun> runs;
};

/// All programs with one setting.
struct MergedSum {
  MergedRun run;  ///< cycle time the sum, contour error the largest, no mean feed; refused: all of them
  std::size_t programs = 0;  ///< that are run
};

struct MergedComparison {
  std::vector<MergedProgram> programs;
  std::vector<MergedSum> sums;   ///< in the order of their first run
  std::optional<double> within;  ///< bound of the contour error [mm]: what was asked for, else of all files

  /// Whether a run keeps the bound; true where there is none, never of one that is refused.
  bool keeps(const MergedRun& run) const;
  /// By run of a program with motion whether it is the fastest that keeps the bound, by sum over all programs
  /// whether that is: all that fastest_runs() names. None where no run keeps the bound, and without a bound.
  std::vector<bool> fastest(const MergedProgram& program) const;
  std::vector<bool> fastest_sums() const;
  /// The first of fastest_sums().
  const MergedSum* fastest_sum() const;
};

/// Name and contents of a file.
struct NamedText {
  std::string name;
  std::string text;
};

/// Reads what `compare --json` wrote, one program each. Runs of two programs are the same setting if machine,
/// axis limits, model and settings are. Throws InputError naming file and key: no JSON (with its place), a
/// number beyond double, lists in lists beyond 64 levels, a key that is missing or of the wrong kind, a
/// program or a setting that is there twice. `within` [mm]: the bound of the contour error; without it the
/// one that all files have been made with.
MergedComparison merge_comparisons(const std::vector<NamedText>& files, std::optional<double> within = {});

/// How the rows over all programs are called in tables.
inline constexpr const char* all_programs = "all programs";

/// program,machine,model,setting,programs,cycle_time_s,mean_feed_mm_min,max_contour_error_mm,errors,segments,
/// within_bound,fastest: a row a run, then one a setting over all programs (program: all_programs), errors
/// and segments their sums. within_bound and fastest are 0 or 1, empty without a bound.
std::string merged_csv(const MergedComparison& merged);
/// programs[{file, errors, segments, runs[{machine, model, setting, cycle_time_s, mean_feed_mm_min,
/// max_contour_error_mm, within_bound, fastest}]}], sums[{machine, model, setting, programs, cycle_time_s,
/// max_contour_error_mm, within_bound, fastest}], within_mm; the last three null without a bound.
std::string merged_json(const MergedComparison& merged);

}  // namespace feedscope
