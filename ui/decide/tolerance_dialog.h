#pragma once

#include <QCoreApplication>
#include <QString>

#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// Asks for the contour tolerances to compare with that of the current run.
class ToleranceDialog {
  Q_DECLARE_TR_FUNCTIONS(ToleranceDialog)

 public:
  /// Empty if there is nothing to compare.
  static std::vector<SetupState> ask(const RunList& runs, QWidget* parent);
  /// The current run's setup with each tolerance of `text` ("0.01 0.02; 0,05") that no run has yet. Throws
  /// InputError naming the error in the text.
  static std::vector<SetupState> setups(const RunList& runs, const QString& text);
};

}  // namespace feedscope::ui
