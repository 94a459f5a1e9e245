#include "ui/runs/comparison_chart.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/language/texts.h"
#include "ui/runs/cause_bar.h"
#include "ui/runs/chart_colours.h"
#include "ui/shared/plot_grid.h"
#include "ui/shared/plot_text.h"

namespace feedscope::ui {

namespace {

constexpr int text_size = 12;
constexpr int small_text_size = 11;
constexpr double swatch = 12;
constexpr double min_bar_with_text = 13;
constexpr double text_room = 8;  // around a text in a bar
constexpr double label_gap = 5;
const QColor band_color(0xf2, 0xf4, 0xf6);

QFont sized(QFont font, int pixels, bool bold = false) {
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

/// "X 35 %" if it fits, else "X" or nothing; no axis if the cause has none.
QString share_in(const QFontMetricsF& metrics, const BarPart& part, double cycle_time, double width) {
  const bool has_axis = part.cause && part.cause->axis >= 0;
  const QString axis = has_axis ? QString(QChar(axis_name(*part.cause))) : QString();
  const QString share =
      ComparisonChart::tr("%1 %").arg(QLocale().toString(100 * part.time / cycle_time, 'f', 0));
  for (const QString& text : {has_axis ? axis + ' ' + share : share, axis}) {
    if (metrics.horizontalAdvance(text) + text_room <= width) {
      return text;
    }
  }
  return {};
}

void draw_programmed_time(QPainter& painter, double position, double top, double bottom) {
  const double x = std::round(position) + 0.5;
  painter.setPen(QPen(QColor(255, 255, 255, 200), 3));
  painter.drawLine(QPointF(x, top), QPointF(x, bottom));
  painter.setPen(QPen(text_color, 1.4, Qt::DashLine));
  painter.drawLine(QPointF(x, top), QPointF(x, bottom));
}

void draw_cell(QPainter& painter, const TextColumn& column, double top, double height, const QString& text) {
  const QRectF cell(column.left, top, column.right - column.left, height);
  painter.drawText(cell, column.side | Qt::AlignVCenter | Qt::TextDontClip, text);
}

}  // namespace

ComparisonChart::ComparisonChart(QWidget* parent) : QWidget(parent) {
  setFont(sized(font(), text_size));
}

void ComparisonChart::set_comparison(const QString& title, const QString& details, ComparisonBars bars) {
  title_ = title;
  details_ = details;
  bars_ = std::move(bars);
  updateGeometry();
  update();
}

QSize ComparisonChart::sizeHint() const {
  constexpr int natural_width = 1280;
  return {natural_width, natural_comparison_height(bars_, natural_width, font())};
}

QSize ComparisonChart::minimumSizeHint() const {
  return {min_comparison_width, min_comparison_height(bars_, width(), font())};
}

void ComparisonChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
}

void ComparisonChart::draw(QPainter& painter) const {
  const ComparisonLayout layout = lay_out(bars_, size(), font());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), Qt::white);
  painter.setFont(font());
  painter.setPen(text_color);
  paint_title(painter, layout.title, title_, details_);
  draw_legend(painter, layout);
  draw_axis(painter, layout);
  draw_columns(painter, layout);
  draw_bars(painter, layout);
  draw_machines(painter, layout);
}

void ComparisonChart::draw_legend(QPainter& painter, const ComparisonLayout& layout) const {
  const QFontMetricsF metrics(font());
  for (std::size_t i = 0; i < layout.legend.size(); ++i) {
    const QRectF& entry = layout.legend[i];
    const QRectF square(entry.left(), entry.center().y() - swatch / 2, swatch, swatch);
    if (i + 1 == layout.legend.size()) {
      draw_programmed_time(painter, square.center().x(), square.top() - 2, square.bottom() + 2);
    } else if (i < bars_.kinds.size()) {
      fill_cause(painter, square, bars_.kinds[i]);
    } else if (i == bars_.kinds.size() && bars_.rest) {
      fill_cause(painter, square, std::nullopt);
    } else {
      painter.fillRect(square, axis_color);
      hatch_refused(painter, square);
    }
    painter.setPen(text_color);
    const QRectF room = entry.adjusted(legend_swatch, 0, 0, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                     metrics.elidedText(layout.legend_texts[i], Qt::ElideRight, room.width() + 1));
  }
}

void ComparisonChart::draw_columns(QPainter& painter, const ComparisonLayout& layout) const {
  const QRectF& head = layout.headings;
  const double line = head.height() / 2 - 1;
  const auto draw = [&](const TextColumn& column) {
    painter.setPen(axis_color.darker(140));
    draw_cell(painter, column, head.top(), line, column.heading);
    draw_cell(painter, column, head.top() + line - 2, line, column.below);
    painter.setPen(text_color);
    for (std::size_t i = 0; i < layout.rows.size(); ++i) {
      draw_cell(painter, column, layout.rows[i].top(), layout.rows[i].height(), column.texts[i]);
    }
  };
  painter.setFont(font());
  std::ranges::for_each(layout.names, draw);
  std::ranges::for_each(layout.figures, draw);
  painter.setPen(axis_color.darker(140));
  painter.drawText(QRectF(layout.plot.left(), head.top() + line - 2, layout.plot.width(), line),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("cycle time by limiting cause"));
}

void ComparisonChart::draw_axis(QPainter& painter, const ComparisonLayout& layout) const {
  const QRectF& plot = layout.plot;
  painter.setFont(sized(font(), small_text_size));
  const double line = QFontMetricsF(painter.font()).height();
  PlotGrid grid(painter, plot, {grid_color, axis_color, text_color, 8, 5});
  for (std::size_t i = 0; i < layout.ticks.values.size(); ++i) {
    grid.upright(layout.x_of(layout.ticks.values[i]), time_tick_text(layout.ticks, i),
                 i == 0 ? GridLine::strong : GridLine::usual);
  }
  painter.setPen(text_color);
  painter.drawText(QRectF(plot.left(), plot.bottom() + 5 + line, plot.width(), line),
                   Qt::AlignHCenter | Qt::AlignTop, time_scale_title(tr("Time"), layout.ticks));
}

void ComparisonChart::draw_machines(QPainter& painter, const ComparisonLayout& layout) const {
  const QFont bold = sized(font(), text_size, true);
  const QFontMetricsF bold_metrics(bold);
  std::size_t row = 0;
  for (std::size_t m = 0; m < bars_.machines.size(); ++m) {
    const MachineBars& machine = bars_.machines[m];
    const QRectF& head = layout.machines[m];
    draw_programmed_time(painter, layout.x_of(machine.programmed_time), head.bottom(),
                         layout.rows[row + machine.bars.size() - 1].bottom());
    row += machine.bars.size();
    painter.fillRect(head.adjusted(-label_gap, 1, label_gap, -1), band_color);
    painter.setPen(text_color);
    painter.setFont(font());
    const QString time = tr("programmed time %1").arg(clock_text(machine.programmed_time));
    const double room = head.width() - QFontMetricsF(font()).horizontalAdvance(time) - 4 * label_gap;
    const QString name =
        bold_metrics.elidedText(QString::fromStdString(machine.machine), Qt::ElideRight, room);
    const double left = std::max(head.left() + bold_metrics.horizontalAdvance(name) + 3 * label_gap,
                                 layout.plot.left() + label_gap);
    painter.drawText(QRectF(left, head.top(), head.right() - left, head.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, time);
    painter.setFont(bold);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, name);
  }
}

void ComparisonChart::draw_bars(QPainter& painter, const ComparisonLayout& layout) const {
  painter.setFont(sized(font(), layout.bar_height >= 16 ? small_text_size : small_text_size - 1));
  std::size_t row = 0;
  for (const MachineBars& machine : bars_.machines) {
    const double programmed = layout.x_of(machine.programmed_time);
    for (const ComparisonBar& bar : machine.bars) {
      const QRectF& area = layout.rows[row++];
      const double top = std::round(area.center().y() - layout.bar_height / 2);
      const auto text = [&](const BarPart& part, double width) {
        return layout.bar_height < min_bar_with_text
                   ? QString()
                   : share_in(QFontMetricsF(painter.font()), part, bar.cycle_time, width);
      };
      paint_cause_bar(painter, bar,
                      {QRectF(layout.plot.left(), top, layout.plot.width(), layout.bar_height),
                       layout.pixels_per_second, programmed, text});
    }
  }
}

}  // namespace feedscope::ui
