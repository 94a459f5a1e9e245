#pragma once

#include <QCoreApplication>
#include <QString>

#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// Asks for the contour tolerances that the current run is to be compared with.
class ToleranceDialog {
  Q_DECLARE_TR_FUNCTIONS(ToleranceDialog)

 public:
  /// Empty where nothing is to be compared.
  static std::vector<SetupState> ask(const RunList& runs, QWidget* parent);
  /// Setups as that of the current run with each tolerance of `text` ("0.01 0.02; 0,05") that no run has yet.
  /// Throws InputError that says what is wrong with the text.
  static std::vector<SetupState> setups(const RunList& runs, const QString& text);
};

}  // namespace feedscope::ui
