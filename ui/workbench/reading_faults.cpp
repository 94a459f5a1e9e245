#include "ui/workbench/reading_faults.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/program/path/other_axes.h"
#include "ui/language/in_language.h"

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

QString not_counted_text(const NotCounted& counts) {
  QStringList texts;
  const auto add = [&](std::size_t count, const QString& one, const QString& several) {
    if (count > 0) {
      texts.append(count == 1 ? one : several.arg(count));
    }
  };
  add(counts.tool_changes, Faults::tr("1 tool change"), Faults::tr("%1 tool changes"));
  add(counts.spindle_starts, Faults::tr("1 spindle start"), Faults::tr("%1 spindle starts"));
  add(counts.stops, Faults::tr("1 program stop"), Faults::tr("%1 program stops"));
  add(counts.machine_moves, Faults::tr("1 move to or from a machine position"),
      Faults::tr("%1 moves to or from machine positions"));
  add(counts.plane_turns, Faults::tr("1 turn of rotary axes for a tilted plane"),
      Faults::tr("%1 turns of rotary axes for tilted planes"));
  add(counts.tip_followings,
      Faults::tr("1 possible delay by X, Y and Z that follow rotary axes (tool length or part zero unknown)"),
      Faults::tr("%1 possible delays by X, Y and Z that follow rotary axes (tool length or part zero "
                 "unknown)"));
  if (!counts.other_axes.empty()) {
    QStringList axes;
    for (const std::string& axis : counts.other_axes) {
      axes.append(axis == orientation_axis ? in_language(NC_("core", "tool orientation"))
                                           : QString::fromStdString(axis));
    }
    texts.append(Faults::tr("motion of %1").arg(axes.join(QStringLiteral(", "))));
  }
  return texts.isEmpty() ? QString()
                         : Faults::tr("Not in the cycle time: %1").arg(texts.join(QStringLiteral(", ")));
}

}  // namespace feedscope::ui
