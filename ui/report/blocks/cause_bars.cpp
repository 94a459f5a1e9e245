#include "ui/report/blocks/cause_bars.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"
#include "ui/runs/cause_bar.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/fonts.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

constexpr int bar_type = 10;
constexpr double bar_row = 24;  // [1/96 inch]
constexpr double bar_height = 16;
constexpr double letter_room = 20;
constexpr double time_room = 62;  // "12:34:56" after the longest bar
constexpr double legend_row = 15;
constexpr double legend_square = 9;
const QColor bar_ink(0x22, 0x26, 0x2a);

/// Combines the axes of each kind of cause.
ComparisonBar by_kind(ComparisonBar bar) {
  std::vector<BarPart> kinds;
  for (const BarPart& part : bar.parts) {
    const bool same = !kinds.empty() && kinds.back().cause.has_value() == part.cause.has_value() &&
                      (!part.cause || kinds.back().cause->kind == part.cause->kind);
    if (same) {
      kinds.back().time += part.time;
    } else {
      kinds.push_back(part);
    }
  }
  bar.parts = std::move(kinds);
  return bar;
}

std::vector<QRectF> legend_places(const ComparisonBars& bars, double width, double top) {
  const QFontMetricsF metrics(paper_font(bar_type));
  std::vector<double> widths;
  for (const QString& text : cause_legend(bars)) {
    widths.push_back(legend_square + 9 + metrics.horizontalAdvance(text));
  }
  constexpr double gap = 12;
  return entries_in_rows(widths, QRectF(0, top, width, legend_row), legend_row, legend_row, gap);
}

/// Whole seconds on the clock: "0:14", "4:13:15".
QString clock_part(double time) {
  const double whole = std::round(time);
  constexpr double minute = 60;
  return whole < minute ? QStringLiteral("0:%1").arg(whole, 2, 'f', 0, QLatin1Char('0'))
                        : clock_text(whole).section(QLocale().decimalPoint(), 0, 0);
}

}  // namespace

bool CauseBars::on_the_clock() const {
  constexpr double minute = 60;
  return std::ranges::any_of(bars_.machines, [](const MachineBars& machine) {
    return std::ranges::any_of(machine.bars, [](const ComparisonBar& bar) {
      return std::ranges::any_of(by_kind(bar).parts, [](const BarPart& part) { return part.time >= minute; });
    });
  });
}

CauseBars::CauseBars(ComparisonBars bars, double width)
    : bars_(std::move(bars)), legend_top_(bar_row * static_cast<double>(bars_.count()) + 4) {
  const std::vector<QRectF> legend = legend_places(bars_, width, legend_top_);
  size_ = {width, legend.empty() ? legend_top_ : legend.back().bottom() + 2};
}

void CauseBars::paint(QPainter& painter) const {
  painter.setFont(paper_font(bar_type));
  double top = 0;
  std::size_t row = 0;
  for (const MachineBars& machine : bars_.machines) {
    for (const ComparisonBar& bar : machine.bars) {
      painter.setPen(bar_ink);
      painter.setFont(paper_font(bar_type, true));
      painter.drawText(QRectF(0, top, letter_room, bar_row), Qt::AlignLeft | Qt::AlignVCenter,
                       bars_.count() > 1 ? run_letter(row) : QString());
      painter.setFont(paper_font(bar_type));
      paint_bar(painter, bar, {letter_room, top, size_.width() - letter_room - time_room, bar_row});
      top += bar_row;
      ++row;
    }
  }
  paint_legend(painter);
}

void CauseBars::paint_bar(QPainter& painter, const ComparisonBar& bar, const QRectF& room) const {
  const QFontMetricsF metrics(painter.font());
  const auto time = [&, clock = on_the_clock()](const BarPart& part, double width) {
    const QString text = clock ? clock_part(part.time) : fixed(part.time, part.time < 10 ? 1 : 0);
    return metrics.horizontalAdvance(text) + 6 <= width ? text : QString();
  };
  const double top = room.top() + (bar_row - bar_height) / 2;
  const double end = paint_cause_bar(painter, by_kind(bar),
                                     {QRectF(room.left(), top, room.width(), bar_height),
                                      bars_.longest > 0 ? room.width() / bars_.longest : 0,
                                      {},
                                      time});
  painter.setPen(bar_ink);
  const QString after = bar.refused        ? ReportWords::tr("refused")
                        : bar.out_of_reach ? ReportWords::tr("out of reach")
                                           : clock_text(bar.cycle_time);
  painter.drawText(QRectF(end + 5, room.top(), size_.width() - end - 5, bar_row),
                   Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, after);
}

void CauseBars::paint_legend(QPainter& painter) const {
  const std::vector<QRectF> places = legend_places(bars_, size_.width(), legend_top_);
  const std::vector<QString> texts = cause_legend(bars_);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const QRectF square(places[i].left(), places[i].center().y() - legend_square / 2, legend_square,
                        legend_square);
    fill_cause(painter, square, i < bars_.kinds.size() ? std::optional(bars_.kinds[i]) : std::nullopt);
    painter.setPen(bar_ink);
    painter.drawText(places[i].adjusted(legend_square + 5, 0, 2, 0),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, texts[i]);
  }
}

}  // namespace feedscope::ui
