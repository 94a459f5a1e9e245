#include <array>
#include <cmath>
#include <utility>

#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

namespace {

using Peak = double AxisPeaks::*;
using Limit = double AxisLimits::*;

struct AxisQuantity {
  const char* name;
  Peak peak;
  Limit limit;
  Dimension dimension;
};
constexpr AxisQuantity quantities[] = {
    {QT_TRANSLATE_NOOP("ReportWords", "Velocity"), &AxisPeaks::velocity, &AxisLimits::velocity,
     Dimension::velocity},
    {QT_TRANSLATE_NOOP("ReportWords", "Acceleration"), &AxisPeaks::acceleration, &AxisLimits::acceleration,
     Dimension::acceleration},
    {QT_TRANSLATE_NOOP("ReportWords", "Jerk"), &AxisPeaks::jerk, &AxisLimits::jerk, Dimension::jerk}};

/// Peaks of rotary axes; empty if none turns in any run.
QString rotary_peaks_block(const ReportInput& input) {
  constexpr std::array<Dimension, 3> turning{Dimension::turning, Dimension::turning_acceleration,
                                             Dimension::turning_jerk};
  constexpr std::array<double RotaryAxis::*, 3> turning_limits{&RotaryAxis::velocity,
                                                               &RotaryAxis::acceleration, &RotaryAxis::jerk};
  HtmlTable table("llrrrr", {28, 8, 16, 16, 16, 16});
  table.add_head({ReportWords::tr("Run"), ReportWords::tr("Axis"), ReportWords::tr("Velocity"),
                  ReportWords::tr("Acceleration"), ReportWords::tr("Jerk"),
                  with_unit_of(ReportWords::tr("Largest lean"), Dimension::angle)});
  const auto cell = [](double peak, double limit, Dimension dimension) {
    return std::isnan(peak) ? ReportWords::tr("jumps")
                            : QStringLiteral("%1 %2<br/><span class=\"muted\">%3 %</span>")
                                  .arg(significant_number(in_shown_unit(peak, dimension), 3),
                                       unit_of(dimension), percent(peak / limit, 0));
  };
  bool any = false;
  for (std::size_t row = 0; row < input.runs.size(); ++row) {
    const ReportRun& run = input.runs[row];
    const std::optional<RotaryFigures>& figures = summary_of(run).rotary;
    if (!figures) {
      continue;
    }
    any = true;
    const Machine& machine = run.shown->run.setup.machine;
    QString label = run_label(input, row);
    QString lean = significant_number(in_shown_unit(figures->orientation.angle, Dimension::angle), 3);
    for (std::size_t i = 0; figures->linear && i < known_axes.size(); ++i) {
      QStringList cells{std::exchange(label, QString()), QString(QChar(known_axes[i].name))};
      const AxisLimits* limits = machine.axes.find(known_axes[i].name);
      for (const AxisQuantity& quantity : quantities) {
        cells.append(cell((*figures->linear)[i].*quantity.peak, limits->*quantity.limit, quantity.dimension));
      }
      cells.append(std::exchange(lean, QString()));
      table.add(cells);
    }
    for (const RotaryAxis& axis : machine.kinematics.rotary) {
      QStringList cells{std::exchange(label, QString()), QString(QChar(axis.name))};
      for (std::size_t k = 0; k < turning.size(); ++k) {
        cells.append(cell(figures->rotary[rotary_names.find(axis.name)].*quantities[k].peak,
                          axis.*turning_limits[k], turning[k]));
      }
      cells.append(std::exchange(lean, QString()));
      table.add(cells);
    }
  }
  return any ? QStringLiteral("<p>%1</p>\n")
                       .arg(ReportWords::tr("Rotary axes, and X, Y and Z of the machine that hold the tip on "
                                            "its path while they turn, with the share of the limit; above "
                                            "are those of the tip. The lean is that of the tool from its "
                                            "programmed direction.")) +
                   table.html()
             : QString();
}

}  // namespace

QString peaks_block(const ReportInput& input) {
  HtmlTable table("lrrrrrrrrr", {28, 8, 8, 8, 8, 8, 8, 8, 8, 8});
  std::vector<std::pair<QString, int>> groups{{ReportWords::tr("Run"), 1}};
  QStringList axes{QString()};
  for (const AxisQuantity& quantity : quantities) {
    groups.emplace_back(with_unit_of(ReportWords::tr(quantity.name), quantity.dimension),
                        static_cast<int>(known_axes.size()));
    for (const AxisInfo& axis : known_axes) {
      axes << QString(QChar(axis.name));
    }
  }
  table.add_group_head(groups);
  table.add_head(axes);
  for (std::size_t row = 0; row < input.runs.size(); ++row) {
    const ReportRun& run = input.runs[row];
    QStringList cells{
        run_label(input, row) +
        QStringLiteral("<br/><span class=\"muted\">%1</span>").arg(ReportWords::tr("of the limit"))};
    for (const AxisQuantity& quantity : quantities) {
      for (const AxisInfo& axis : known_axes) {
        const AxisPeaks* const peaks = summary_of(run).axes.find(axis.name);
        if (peaks == nullptr) {
          cells.append(QString());
          continue;
        }
        const double peak = peaks->*quantity.peak;
        if (std::isnan(peak)) {
          cells.append(ReportWords::tr("jumps"));
          continue;
        }
        const double limit = run.shown->run.setup.machine.axes.find(axis.name)->*quantity.limit;
        cells.append(QStringLiteral("%1<br/><span class=\"muted\">%2 %</span>")
                         .arg(significant_number(in_shown_unit(peak, quantity.dimension), 3),
                              percent(peak / limit, 0)));
      }
    }
    table.add(cells);
  }
  return table.html() + rotary_peaks_block(input);
}

}  // namespace feedscope::ui
