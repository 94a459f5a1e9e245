#include "ui/language/time_texts.h"

#include <QLocale>
#include <cmath>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {

namespace {

constexpr double nothing = 5e-4;  // [s]

QString with_capital(QString text) {
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  return text;
}

/// Seconds for comparisons, with decimals by their size.
QString seconds_text(double seconds) {
  return QLocale().toString(std::abs(seconds), 'f', decimals_of_gain(seconds));
}

QString core_title(std::string_view text) {
  return core_text(std::string(text));
}

}  // namespace

QString TimeTexts::refusal(const Run& run) {
  return tr("<b>The control refuses the program:</b> none of its feed motions is run, and there is no cycle "
            "time to explain. Lines that are not run: %1.")
      .arg(in_language(line_list(run.lines_not_run)));
}

QString TimeTexts::lost_to(const SlowGroup& group) {
  return group.kind == CauseKind::programmed_feed ? core_text(feedscope::lost_to(group))
                                                  : shown_cause(group.cause);
}

QString TimeTexts::conclusion(const TimeReport& report, const Run& run) {
  const TimeUse& use = report.use;
  if (!(use.cycle_time > 0)) {
    return tr("Nothing in this program takes time.");
  }
  QString text = tr("<b>%1</b> for %2 programmed: <b>%3</b> (%4 of the cycle time).")
                     .arg(clock_text(use.cycle_time), clock_text(use.programmed_time), change(use.lost()),
                          percent(use.lost(), use.cycle_time));
  for (const Message& remark : texts_about(remarks(run, unit_system()), {Remark::About::programmed})) {
    text += QLatin1Char(' ') + in_language(remark).toHtmlEscaped();
  }
  if (use.mean_feed > 0) {
    const QString feed = amount_text(use.mean_feed, Dimension::feed);
    text +=
        QLatin1Char(' ') +
        (use.pauses() > nothing
             ? tr("Mean feed with rapids %1, without pauses of %2 s.").arg(feed, seconds_text(use.pauses()))
             : tr("Mean feed with rapids %1.").arg(feed));
  }
  if (!report.slow.groups.empty() && report.slow.groups.front().loss > nothing) {
    const SlowGroup& most = report.slow.groups.front();
    text +=
        QLatin1Char(' ') +
        tr("Most is lost here: <b>%1</b> (%2 s).").arg(group(most).toHtmlEscaped(), seconds_text(most.loss));
  }
  if (const Message refused = refused_note(run.lines_not_run); !refused.empty()) {
    text += QLatin1Char(' ') + in_language(refused);
  }
  return text;
}

QString TimeTexts::kind(TimeKind kind) {
  return with_capital(core_title(time_kind_title(kind)));
}

QString TimeTexts::cause(Cause cause) {
  return with_capital(shown_cause(cause));
}

QString TimeTexts::group(const SlowGroup& group) {
  return tr("%1: %2").arg(with_capital(core_title(info_of(group.shape).title)), lost_to(group));
}

QString TimeTexts::measure(const SlowGroup& group) {
  const PlaceShapeInfo& info = info_of(group.shape);
  if (info.measure.empty()) {
    return {};
  }
  const auto value = [&](double inside) {
    return info.dimension == Dimension::angle ? tr("%1°").arg(significant_number(units::to_deg(inside), 3))
                                              : significant_text(inside, Dimension::length, 3);
  };
  const QString what = core_title(info.measure);
  return value(group.smallest) == value(group.largest)
             ? tr("%1 %2").arg(what, value(group.median))
             : tr("%1 %2 to %3, median %4")
                   .arg(what, value(group.smallest), value(group.largest), value(group.median));
}

QString TimeTexts::in_common(const SlowGroup& group) {
  const QString count = group.count == 1
                            ? tr("1 place")
                            : tr("%1 places").arg(QLocale().toString(static_cast<qulonglong>(group.count)));
  const QString measured = measure(group);
  return measured.isEmpty() ? count : tr("%1, %2").arg(count, measured);
}

QString TimeTexts::change(double seconds) {
  return std::abs(seconds) < nothing ? QStringLiteral("0")
                                     : QChar(seconds < 0 ? 0x2212 : '+') + gain(std::abs(seconds));
}

QString TimeTexts::gain(double seconds) {
  constexpr double minute = 60;
  return std::abs(seconds) < minute
             ? tr("%1 s").arg(QLocale().toString(seconds, 'f', decimals_of_gain(seconds)))
             : clock_text(seconds);
}

QString TimeTexts::percent(double part, double of) {
  return of > 0 ? tr("%1 %").arg(QLocale().toString(100 * part / of, 'f', 1)) : QString();
}

}  // namespace feedscope::ui
