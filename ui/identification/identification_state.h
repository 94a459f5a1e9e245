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

/// What a user has chosen to be fitted.
struct FitChoiceState {
  std::optional<std::size_t> run;  ///< that is begun with, by its row; none: the current one
  QString machine;                 ///< key of a machine to begin with instead of a run; empty: none
  bool typical = false;            ///< begun with a typical machine of each model instead
  std::optional<std::vector<std::string>> models;  ///< ticked by the user; none: that of the run
  std::map<std::string, bool> wanted;              ///< keys that the user has ticked or not

  bool operator==(const FitChoiceState&) const = default;
};

/// A table of section times, and whether it is used.
struct TableState {
  std::shared_ptr<const SectionTable> table;
  bool used = true;
};

/// What was found, and which of its models is looked at.
struct IdentificationResult {
  std::shared_ptr<const IdentificationOutcome> outcome;  ///< null: nothing yet
  std::size_t chosen = 0;                                ///< of its models
  bool stale = false;                                    ///< recordings, models or machine have changed since
};

/// What a user has set and found in the identification, as sessions get it back.
struct IdentificationState {
  std::vector<std::size_t> unused_traces;  ///< rows of the program's traces that are not ticked
  std::vector<TableState> tables;
  FitChoiceState choice;
  IdentificationResult result;
};

}  // namespace feedscope::ui
