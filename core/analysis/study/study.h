#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/study/compare.h"
#include "core/analysis/study/operations.h"
#include "core/analysis/study/sweep.h"

namespace feedscope {

/// Scope of a study: machines, models, tolerances and assignments as for setups_to_compare.
struct StudyRequest {
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<double> tolerances;  ///< [mm]
  std::vector<std::string> assignments;
  std::vector<Sweep> sweeps;
  OperationSplit split = OperationSplit::none;
  std::optional<double> within;  ///< bound of the contour error [mm]
  /// Runs of a session, in place of machines, models, tolerances and assignments, which must be empty.
  std::vector<Setup> setups = {};
  LoadSetup load = {};  ///< of all runs, unless empty
};

/// One run of a study.
struct StudySetup {
  Setup setup;
  std::vector<double> swept;  ///< value for each sweep
};

/// Every setup of setups_to_compare() with every combination of the swept values; the first sweep varies
/// fastest. Models without a swept key are omitted. Throws InputError as setups_to_compare and apply_swept
/// do; for a key that no model has, with the nearest one; for a key swept or set twice; beyond
/// max_study_runs.
std::vector<StudySetup> setups_to_study(const StudyRequest& request);

/// Figures of one run.
struct StudyRun : ComparedRun {
  std::vector<double> swept;                 ///< value for each sweep
  std::vector<OperationFigures> operations;  ///< one per Study::operations
};

struct Study {
  std::vector<Sweep> sweeps;
  std::optional<double> within;  ///< [mm]
  std::vector<Operation> operations;
  std::vector<StudyRun> runs;

  /// Runs that differ only in the value of the first sweep, neighbours in `runs`: one curve. Without a sweep
  /// each run is one.
  std::vector<std::span<const StudyRun>> curves() const;
};

/// Runs all setups as compare_runs does, and throws likewise.
Study run_study(const LoadedProgram& program, const StudyRequest& request, Progress* progress = nullptr);

/// First of the fastest_runs(); null if there is none.
const StudyRun* fastest(std::span<const StudyRun> runs, std::optional<double> within);

/// Whether several runs all take the same time and none is excluded by the bound or by refused lines: for a
/// curve, whether its setting makes no difference.
bool makes_no_difference(std::span<const StudyRun> runs, std::optional<double> within);

/// Whether each run of a curve is marked as its fastest: all fastest_runs(); none if the setting makes no
/// difference.
std::vector<bool> fastest_marks(std::span<const StudyRun> curve, std::optional<double> within);

/// The run of a curve to take, as recommend(): null if no run keeps the bound.
const StudyRun* recommended(std::span<const StudyRun> runs, std::optional<double> within);

/// Whether each run of a curve is marked as the one to take: recommended() and those equal to it; none if the
/// setting makes no difference.
std::vector<bool> recommended_marks(std::span<const StudyRun> curve, std::optional<double> within);

}  // namespace feedscope
