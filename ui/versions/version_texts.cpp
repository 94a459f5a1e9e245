#include "ui/versions/version_texts.h"

#include <QLocale>
#include <cmath>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/signed_number.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

namespace {

constexpr int decimals = 3;

QString signed_seconds(double time) {
  return QStringLiteral("%1 s").arg(signed_number(time, decimals));
}

}  // namespace

QString VersionTexts::seconds(double time) {
  return QStringLiteral("%1 s").arg(QLocale().toString(time, 'f', decimals));
}

QString VersionTexts::change(const StretchSide& old, const StretchSide& now) {
  return signed_seconds(now.time - old.time);
}

QString VersionTexts::lines(const StretchSide& side) {
  return side.first_line == 0                ? QStringLiteral("–")
         : side.first_line == side.last_line ? QString::number(side.first_line)
                                             : tr("%1–%2").arg(side.first_line).arg(side.last_line);
}

QString VersionTexts::conclusion(const Run& old, const Run& now, const ProgramDifference& difference) {
  const double before = old.summary.cycle_time;
  const double after = now.summary.cycle_time;
  const QString share =
      before > 0 ? tr(" (%1 %)").arg(signed_number(100 * (after / before - 1), 1)) : QString();
  const auto path = [](const Run& run) { return std::filesystem::path(run.input.program->source->name()); };
  const bool alike = path(old).filename() == path(now).filename();  // in two folders
  const auto name = [&](const Run& run) {
    return to_qstring(alike ? path(run) : path(run).filename()).toHtmlEscaped();
  };
  const QString faulty = has_errors(old.input.program->diagnostics)
                             ? tr(" <b>The older program was read with errors.</b>")
                             : QString();
  return tr("<b>%1</b> instead of %2: %3 instead of %4, <b>%5</b>%6. %7 % of the new path is in the older "
            "program too. Max. contour error %8 instead of %9.")
             .arg(name(now), name(old), seconds(after), seconds(before), signed_seconds(after - before),
                  share, QLocale().toString(100 * difference.same_share(), 'f', 1),
                  amount_text(now.summary.cutting_contour_error, Dimension::error),
                  amount_text(old.summary.cutting_contour_error, Dimension::error)) +
         faulty;
}

}  // namespace feedscope::ui
