#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/compare.h"
#include "core/analysis/study/operations.h"
#include "core/analysis/study/sweep.h"

namespace feedscope {

/// What is to be studied: machines, models, tolerances and assignments as setups_to_compare.
struct StudyRequest {
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<double> tolerances;  ///< [mm]
  std::vector<std::string> assignments;
  std::vector<Sweep> sweeps;
  OperationSplit split = OperationSplit::none;
  std::optional<double> within;  ///< bound of the contour error [mm]
  /// Instead of machines, models, tolerances and assignments, which are empty then: the runs of a session.
  std::vector<Setup> setups = {};
  LoadSetup load = {};  ///< of all runs, unless it is empty
};

/// One run of a study.
struct StudySetup {
  Setup setup;
  std::vector<double> swept;  ///< value of every sweep
};

/// Every setup of setups_to_compare() with every combination of the swept values; the first sweep changes
/// from run to run. Models that do not know a swept key are omitted.
/// Throws InputError as setups_to_compare and apply_swept; for a key that none of the models knows with the
/// nearest one; for a key that is swept or set twice; beyond max_study_runs.
std::vector<StudySetup> setups_to_study(const StudyRequest& request);

/// Figures of one of the runs.
struct StudyRun : ComparedRun {
  std::vector<double> swept;                 ///< value of every sweep
  std::vector<OperationFigures> operations;  ///< one a Study::operations
};

struct Study {
  std::vector<Sweep> sweeps;
  std::optional<double> within;  ///< [mm]
  std::vector<Operation> operations;
  std::vector<StudyRun> runs;

  /// Runs that differ in the value of the first sweep alone, neighbours in `runs`: one curve. Without a sweep
  /// each run is one.
  std::vector<std::span<const StudyRun>> curves() const;
};

/// Runs them all as compare_runs does. Throws as that.
Study run_study(const LoadedProgram& program, const StudyRequest& request, Progress* progress = nullptr);

/// The first of those that fastest_runs() names; null for none.
const StudyRun* fastest(std::span<const StudyRun> runs, std::optional<double> within);

/// Whether several runs all take the same time, none of the bound or of refused lines apart from the others:
/// of a curve, that its setting makes no difference.
bool makes_no_difference(std::span<const StudyRun> runs, std::optional<double> within);

/// By run of a curve whether it is marked as its fastest: all that fastest_runs() names; none where the
/// setting makes no difference.
std::vector<bool> fastest_marks(std::span<const StudyRun> curve, std::optional<double> within);

}  // namespace feedscope
