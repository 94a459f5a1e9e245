#include "ui/trace/trace_tables.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/operation_title.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/signed_number.h"
#include "ui/language/texts.h"
#include "ui/workbench/trace_messages.h"

namespace feedscope::ui {

namespace {

struct TraceTables {
  Q_DECLARE_TR_FUNCTIONS(TraceTables)
};

constexpr std::size_t most_corners = 200;

QString plain(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

QList<QStandardItem*> cells(const QStringList& texts) {
  QList<QStandardItem*> row;
  for (const QString& text : texts) {
    auto* item = new QStandardItem(text);
    item->setEditable(false);
    item->setTextAlignment(row.isEmpty() ? Qt::AlignLeft | Qt::AlignVCenter
                                         : Qt::AlignRight | Qt::AlignVCenter);
    row.append(item);
  }
  return row;
}

void add_row(QStandardItemModel& table, const QStringList& texts, const QString& tip = {}) {
  const QList<QStandardItem*> row = cells(texts);
  for (QStandardItem* item : row) {
    item->setToolTip(tip);
  }
  table.appendRow(row);
}

void add_place(QStandardItemModel& table, const QStringList& texts, double s, double reach) {
  const QList<QStandardItem*> row = cells(texts);
  for (QStandardItem* item : row) {
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setData(s, trace_place_role);
    item->setData(reach, trace_reach_role);
    item->setToolTip(TraceTables::tr("Click to go there"));
  }
  table.appendRow(row);
}

void begin(QStandardItemModel& table, const QStringList& titles, const QStringList& tips) {
  table.clear();
  table.setHorizontalHeaderLabels(titles);
  for (int column = 0; column < tips.size(); ++column) {
    table.horizontalHeaderItem(column)->setToolTip(tips[column]);
  }
}

void begin_figures(QStandardItemModel& table) {
  begin(table,
        {TraceTables::tr("Figure"), TraceTables::tr("Trace"), TraceTables::tr("Simulated"),
         TraceTables::tr("Difference")},
        {TraceTables::tr("Over the part of the program that the trace covers"),
         TraceTables::tr("What the control recorded"), TraceTables::tr("The current run"),
         TraceTables::tr("Simulated against recorded")});
}

/// Column titles with the unit on a second line, so that the tables are narrow enough to be side by side.
QStringList over_two_lines(QStringList titles) {
  return titles.replaceInStrings(QStringLiteral(" ["), QStringLiteral("\n["));
}

void begin_places(QStandardItemModel& table) {
  begin(table,
        over_two_lines({TraceTables::tr("Line"), with_unit_of(TraceTables::tr("Trace"), Dimension::feed),
                        TraceTables::tr("Simulated"), TraceTables::tr("Lost [ms]")}),
        {TraceTables::tr("Program line"), TraceTables::tr("Feed of the trace there"),
         TraceTables::tr("Feed of the current run there, in the same unit"),
         TraceTables::tr("Time that the control took more than the simulation; below 0: less")});
}

void begin_corners(QStandardItemModel& table) {
  begin(
      table,
      over_two_lines({TraceTables::tr("Line"), TraceTables::tr("Turn [°]"),
                      with_unit_of(TraceTables::tr("Trace"), Dimension::feed), TraceTables::tr("Simulated"),
                      TraceTables::tr("Off [%]")}),
      {TraceTables::tr("Program line that ends at the corner"), TraceTables::tr("Change of direction"),
       TraceTables::tr("Mean feed of the trace from 0.5 mm before the corner to 0.5 mm behind it, less where "
                       "blocks are short"),
       TraceTables::tr("The same of the current run, in the same unit"),
       TraceTables::tr("Simulated against recorded")});
}

}  // namespace

void clear_tables(QStandardItemModel& figures, QStandardItemModel& places, QStandardItemModel& corners) {
  begin_figures(figures);
  begin_places(places);
  begin_corners(corners);
}

void fill_figures(QStandardItemModel& table, const ShownTrace& shown) {
  const Agreement& agreement = shown.agreement;
  begin_figures(table);
  add_row(table,
          {agreement.whole ? TraceTables::tr("Cycle time") : TraceTables::tr("Time of the part compared"),
           clock_text(agreement.measured_time), clock_text(agreement.simulated_time),
           TraceTables::tr("%1 %").arg(signed_number(100 * agreement.time_error(), 2))});
  for (const OperationAgreement& operation : agreement.operations) {
    const QString title = operation_title(operation.title, operation.line, agreement.split);
    add_row(
        table,
        {operation.title == title_of_line(operation.line)
             ? title
             : TraceTables::tr("Line %1: %2").arg(operation.line).arg(title),
         clock_text(operation.measured_time), clock_text(operation.simulated_time),
         TraceTables::tr("%1 s").arg(signed_number(operation.simulated_time - operation.measured_time, 3))});
  }
  add_row(table, {TraceTables::tr("Feed (rms)"), {}, {}, amount_text(agreement.feed_rms, Dimension::feed)},
          TraceTables::tr("Root mean square of the difference of the feeds over the path"));
  if (!agreement.corners.empty()) {
    add_row(table,
            {TraceTables::tr("%1 corners (rms)").arg(agreement.corners.size()),
             {},
             {},
             TraceTables::tr("%1 %").arg(plain(100 * agreement.corner_rms(), 1))},
            TraceTables::tr("Root mean square of the difference of the mean feeds through corners"));
  }
  add_row(table, {TraceTables::tr("Largest distance from the path"),
                  amount_text(agreement.distance, Dimension::error),
                  amount_text(agreement.simulated_distance, Dimension::error),
                  {}});
  for (std::size_t i = 0; shown.found.pass_times.size() > 1 && i < shown.found.pass_times.size(); ++i) {
    add_row(table, {TraceTables::tr("Pass %1").arg(i + 1), clock_text(shown.found.pass_times[i]), {}, {}});
  }
}

void fill_worst_places(QStandardItemModel& table, const ShownTrace& shown) {
  constexpr double shown_around = 2;  // [mm]
  begin_places(table);
  for (const WorstPlace& place : shown.agreement.worst) {
    add_place(
        table,
        {QString::number(place.line), number_text(place.measured_feed, Dimension::feed),
         number_text(place.simulated_feed, Dimension::feed), signed_number(units::to_ms(place.lost), 2)},
        place.s, shown_around);
  }
}

void fill_corners(QStandardItemModel& table, const ShownTrace& shown) {
  std::vector<const CornerAgreement*> corners;
  for (const CornerAgreement& corner : shown.agreement.corners) {
    corners.push_back(&corner);
  }
  std::ranges::stable_sort(corners, std::ranges::greater(),
                           [](const CornerAgreement* corner) { return std::abs(corner->error()); });
  corners.resize(std::min(corners.size(), most_corners));
  begin_corners(table);
  constexpr double shown_around = 3;  // reaches
  for (const CornerAgreement* corner : corners) {
    add_place(table,
              {QString::number(corner->line), plain(units::to_deg(corner->turn), 1),
               number_text(corner->measured_feed, Dimension::feed),
               number_text(corner->simulated_feed, Dimension::feed), signed_number(100 * corner->error(), 1)},
              corner->s, shown_around * corner->reach);
  }
}

QString verdict_of(const ShownTrace& shown) {
  const Agreement& agreement = shown.agreement;
  const QString percent = plain(std::abs(100 * agreement.time_error()), 2);
  constexpr double not_shown = 0.5e-4;  // in percent with two decimals
  const QString time = std::abs(agreement.time_error()) < not_shown
                           ? TraceTables::tr("The simulation is as fast as the control")
                       : agreement.time_error() < 0
                           ? TraceTables::tr("The simulation is %1 % faster than the control").arg(percent)
                           : TraceTables::tr("The simulation is %1 % slower than the control").arg(percent);
  if (!shown.found.belongs()) {
    return message_text(shown.found.remarks.front());
  }
  constexpr double most_of_it = 0.5;
  if (shown.found.share < most_of_it) {
    return TraceTables::tr("The trace covers %1 % of the path. %2 there (%3 and %4).")
        .arg(plain(100 * shown.found.share, 1), time, clock_text(agreement.simulated_time),
             clock_text(agreement.measured_time));
  }
  const QString verdict =
      TraceTables::tr("%1 (%2 and %3); their feeds differ by %4 (rms over the path).")
          .arg(time, clock_text(agreement.simulated_time), clock_text(agreement.measured_time),
               amount_text(agreement.feed_rms, Dimension::feed));
  return agreement.held_time > 0
             ? TraceTables::tr(
                   "%1 Without the %2 for which the trace stands still, the times differ by %3 %.")
                   .arg(verdict, clock_text(agreement.held_time),
                        signed_number(100 * agreement.time_error_without_holds(), 2))
             : verdict;
}

QStringList remarks_of(const ShownTrace& shown) {
  const QLocale locale;
  constexpr int digits = 3;
  QStringList remarks;
  std::vector<Diagnostic> messages = messages_on(*shown.trace, shown.found);
  if (!shown.found.belongs()) {
    messages.erase(messages.begin());  // contained in the verdict
  }
  for (const Diagnostic& message : messages) {
    remarks.append(message_text(message));
  }
  const Vec3& offset = shown.found.pose.offset;
  constexpr double noticed = 1e-3;  // [mm]
  if (offset.norm() > noticed) {
    remarks.append(TraceTables::tr("The trace was moved by X %1 Y %2 Z %3 onto the program.")
                       .arg(number_text(offset.x(), Dimension::length),
                            number_text(offset.y(), Dimension::length),
                            amount_text(offset.z(), Dimension::length)));
  }
  remarks.append(TraceTables::tr("Read as %1: one sample each %2 ms (%3), noise %4. Its feeds are means over "
                                 "%5 ms, accelerations over %6 ms.")
                     .arg(core_text(shown.trace->format),
                          locale.toString(units::to_ms(shown.trace->period), 'g', digits),
                          core_text(std::string(title_of(shown.trace->clock))),
                          amount_text(shown.found.noise, Dimension::error),
                          locale.toString(units::to_ms(shown.motion.feed_window()), 'g', digits),
                          locale.toString(units::to_ms(shown.motion.acceleration_window()), 'g', digits)));
  return remarks;
}

}  // namespace feedscope::ui
