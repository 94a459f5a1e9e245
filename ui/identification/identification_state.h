#pragma once

#include <QString>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/identification/identification_outcome.h"

namespace feedscope::ui {

/// The user's choice of models and numbers to fit.
struct FitChoiceState {
  std::optional<std::size_t> run;  ///< initial run, by its row; none: the current one
  QString machine;                 ///< key of an initial machine instead of a run; empty: none
  bool typical = false;            ///< whether a typical machine of each model is used instead
  std::optional<std::vector<std::string>> models;  ///< ticked by the user; none: the run's model
  std::map<std::string, bool> wanted;              ///< keys that the user has ticked or unticked

  bool operator==(const FitChoiceState&) const = default;
};

/// A table of section times, and whether it is used.
struct TableState {
  std::shared_ptr<const SectionTable> table;
  bool used = true;
};

/// The outcome, and its selected model.
struct IdentificationResult {
  std::shared_ptr<const IdentificationOutcome> outcome;  ///< null: none yet
  std::size_t chosen = 0;                                ///< of its models
  bool stale = false;  ///< whether recordings, models or machine have changed since
};

/// The user's choices and results in the identification, restored by sessions.
struct IdentificationState {
  std::vector<std::size_t> unused_traces;  ///< unticked rows of the program's traces
  std::vector<TableState> tables;
  FitChoiceState choice;
  IdentificationResult result;
};

}  // namespace feedscope::ui
