#include "ui/workbench/reading_faults.h"

#include <QCoreApplication>
#include <algorithm>

namespace feedscope::ui {

namespace {

struct Faults {
  Q_DECLARE_TR_FUNCTIONS(Faults)
};

}  // namespace

QString reading_faults_text(const Program& program) {
  const auto count = [&](Severity severity) {
    return std::ranges::count(program.diagnostics, severity, &Diagnostic::severity);
  };
  const auto errors = count(Severity::error);
  const auto warnings = count(Severity::warning);
  const QString of_errors = errors == 1 ? Faults::tr("1 error") : Faults::tr("%1 errors").arg(errors);
  const QString of_warnings =
      warnings == 1 ? Faults::tr("1 warning") : Faults::tr("%1 warnings").arg(warnings);
  if (errors > 0 && warnings > 0) {
    return Faults::tr("Program read with %1 and %2").arg(of_errors, of_warnings);
  }
  if (errors > 0 || warnings > 0) {
    return Faults::tr("Program read with %1").arg(errors > 0 ? of_errors : of_warnings);
  }
  return {};
}

}  // namespace feedscope::ui
