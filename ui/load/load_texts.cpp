#include "ui/load/load_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <string>

#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {
namespace {

struct Load {
  Q_DECLARE_TR_FUNCTIONS(Load)
};

QString seconds(double time) {
  return amount_text(time, Dimension::time);
}

}  // namespace

QString operation_text(const Engagement& operation) {
  constexpr std::size_t most_ranges = 3;
  const QString tool = operation.tool.empty()
                           ? Load::tr("all tools")
                           : Load::tr("tool %1").arg(QString::fromStdString(operation.tool));
  if (operation.lines.empty()) {
    return tool;
  }
  QStringList ranges;
  for (std::size_t i = 0; i < std::min(most_ranges, operation.lines.size()); ++i) {
    ranges.append(QStringLiteral("%1–%2").arg(operation.lines[i].first).arg(operation.lines[i].last));
  }
  if (operation.lines.size() > most_ranges) {
    ranges.append(QStringLiteral("…"));
  }
  return Load::tr("%1, lines %2").arg(tool, ranges.join(QStringLiteral(", ")));
}

QString limit_text(LoadLimit limit) {
  QString text = core_text(std::string(title_of(limit)));
  text.front() = text.front().toUpper();
  return text;
}

QString without_load_text(const LoadFigures& load) {
  const auto time = [&load](LoadState state) { return load.time[static_cast<std::size_t>(state)]; };
  QStringList parts;
  if (time(LoadState::no_operation) > 0) {
    parts.append(
        Load::tr("%1 of feed motions without an operation").arg(seconds(time(LoadState::no_operation))));
  }
  if (time(LoadState::plunge) > 0) {
    parts.append(
        Load::tr("%1 of plunging and drilling, which is not modelled").arg(seconds(time(LoadState::plunge))));
  }
  if (time(LoadState::no_spindle) > 0) {
    parts.append(Load::tr("%1 with a spindle that stands or whose speed is not known")
                     .arg(seconds(time(LoadState::no_spindle))));
  }
  return parts.isEmpty() ? QString() : Load::tr("No load for %1.").arg(parts.join(QStringLiteral(", ")));
}

QString assumptions_text(const LoadFigures& load) {
  return Load::tr("Load over %1 of cutting; %2.")
      .arg(seconds(load.all.cutting_time), core_text(std::string(load_assumptions())));
}

QStringList limits_text(const LoadFigures& load) {
  QStringList sentences;
  for (const LimitFigures& limit : load.limits) {
    const QString places = limit.count == 1 ? Load::tr("one place")
                                            : Load::tr("%1 places").arg(static_cast<qulonglong>(limit.count));
    sentences.append(limit.time > 0 ? Load::tr("%1: %2 in %3, %4 at the programmed feed")
                                          .arg(limit_text(limit.limit), seconds(limit.time), places,
                                               seconds(limit.programmed_time))
                                    : Load::tr("%1: nowhere").arg(limit_text(limit.limit)));
  }
  return sentences;
}

}  // namespace feedscope::ui
