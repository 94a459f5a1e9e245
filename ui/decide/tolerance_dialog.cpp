#include "ui/decide/tolerance_dialog.h"

#include <QInputDialog>
#include <QRegularExpression>
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "ui/fields/number_text.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

namespace {

/// Numbers of "0.01 0.02; 0,05", with decimal point or comma. Throws InputError naming a word that is not a
/// number, and the reason.
QList<double> tolerances_of(const QString& text) {
  QList<double> numbers;
  static const QRegularExpression separators(QStringLiteral("[\\s;]+"));
  for (const QString& word : text.split(separators, Qt::SkipEmptyParts)) {
    const auto number = number_of(word);
    if (!number) {
      const QString hint = ToleranceDialog::tr("Separate the tolerances by spaces or semicolons.");
      throw InputError((number_problem(word) + ' ' + hint).toStdString());
    }
    numbers.append(*number);
  }
  return numbers;
}

/// Whether a run has `setup` with this tolerance [mm].
bool runs_with(const RunList& runs, const RunItem& item, const SetupState& setup, double tolerance) {
  if (!(item.setup.file() == setup.file())) {
    return false;
  }
  SetupState same = item.setup;
  same.set_tolerance(tolerance);
  const auto in_force = runs.tolerance(item);
  return same == setup && in_force && in_force->min == tolerance && in_force->max == tolerance;
}

QString usual_tolerances() {
  const bool metric = unit_system() == UnitSystem::metric;
  const std::array<double, 4> usual =
      metric ? std::array{0.01, 0.02, 0.05, 0.1} : std::array{0.0005, 0.001, 0.002, 0.004};
  QStringList texts;
  for (const double tolerance : usual) {
    texts.append(editable_text(tolerance));
  }
  return texts.join(QLatin1Char(' '));
}

}  // namespace

std::vector<SetupState> ToleranceDialog::ask(const RunList& runs, QWidget* parent) {
  const QString asked = tr("Contour tolerances [%1], separated by spaces:").arg(unit_of(Dimension::length));
  QString text = usual_tolerances();
  QString problem;
  while (true) {  // the error appears above the typed text, which can be corrected there
    bool accepted = false;
    text = QInputDialog::getText(parent, tr("Compare tolerances"),
                                 problem.isEmpty() ? asked : problem + QStringLiteral("\n\n") + asked,
                                 QLineEdit::Normal, text, &accepted);
    if (!accepted) {
      return {};
    }
    try {
      return setups(runs, text);
    } catch (const InputError& error) {
      problem = failure_text(error);
    }
  }
}

std::vector<SetupState> ToleranceDialog::setups(const RunList& runs, const QString& text) {
  std::vector<SetupState> setups;
  for (const double typed : tolerances_of(text)) {
    const double tolerance = from_shown_unit(typed, Dimension::length);
    SetupState setup = runs.current_item().setup;
    setup.set_tolerance(tolerance);
    const bool known = std::ranges::any_of(
        runs.items(), [&](const RunItem& item) { return runs_with(runs, item, setup, tolerance); });
    if (!known && std::ranges::find(setups, setup) == setups.end()) {
      setups.push_back(std::move(setup));
    }
  }
  return setups;
}

}  // namespace feedscope::ui
