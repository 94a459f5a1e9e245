#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// Figures of one run as comparison_json and study_json write them.
struct MergedRun {
  std::string machine;           ///< id
  std::string model;             ///< id
  std::string setting;           ///< "tolerance=0.02 X.jerk=20"; what was swept, or the tolerance
  std::string key;               ///< everything that runs of the same setting share
  double cycle_time = 0;         ///< [s]
  double mean_feed = 0;          ///< [mm/min]
  double max_contour_error = 0;  ///< [mm]
};

struct MergedProgram {
  std::string file;  ///< of the program
  std::vector<MergedRun> runs;
};

/// All programs with one setting.
struct MergedSum {
  MergedRun run;  ///< cycle time the sum, contour error the largest, no mean feed
  std::size_t programs = 0;
};

struct MergedComparison {
  std::vector<MergedProgram> programs;
  std::vector<MergedSum> sums;  ///< in the order of their first run
};

/// Name and contents of a file.
struct NamedText {
  std::string name;
  std::string text;
};

/// Reads what `compare --json` wrote, one program each. Runs of two programs are the same setting if machine,
/// axis limits, model and settings are. Throws InputError naming file and key: no JSON (with its place), a
/// key that is missing or of the wrong kind, a program or a setting that is there twice.
MergedComparison merge_comparisons(const std::vector<NamedText>& files);

/// program,machine,model,setting,programs,cycle_time_s,mean_feed_mm_min,max_contour_error_mm: a row a run,
/// then one a setting over all programs (program empty).
std::string merged_csv(const MergedComparison& merged);
/// programs[{file, runs[{machine, model, setting, cycle_time_s, mean_feed_mm_min, max_contour_error_mm}]}],
/// sums[{machine, model, setting, programs, cycle_time_s, max_contour_error_mm}].
std::string merged_json(const MergedComparison& merged);

}  // namespace feedscope
