#include "ui/runs/comparison_chart.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/runs/chart_colours.h"
#include "ui/scene/cause_colour.h"
#include "ui/shared/plot_grid.h"

namespace feedscope::ui {

namespace {

constexpr int text_size = 12;
constexpr int small_text_size = 11;
constexpr int title_size = 15;
constexpr double swatch = 12;
constexpr double min_bar_with_text = 13;
constexpr double text_room = 8;  // that a text in a bar needs beside itself
constexpr double label_gap = 5;
constexpr double separated = 3;  // a part wider than this is set apart from the one before by a white line
const QColor band_color(0xf2, 0xf4, 0xf6);
const QColor rest_color(0xb4, 0xba, 0xc2);
const QColor refused_color(0xff, 0xff, 0xff, 0xa0);

QFont sized(QFont font, int pixels, bool bold = false) {
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

QColor color_of(CauseKind kind) {
  const Rgb rgb = cause_colour(kind);
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
}

/// Dark or white, whichever shows better on the colour.
QColor text_on(const QColor& color) {
  const double luminance = 0.2126 * std::pow(color.redF(), 2.2) + 0.7152 * std::pow(color.greenF(), 2.2) +
                           0.0722 * std::pow(color.blueF(), 2.2);
  return luminance > 0.27 ? text_color : QColor(Qt::white);
}

void fill_part(QPainter& painter, const QRectF& area, const std::optional<CauseKind>& kind) {
  if (kind) {
    painter.fillRect(area, color_of(*kind));
  } else {
    painter.fillRect(area, Qt::white);
    painter.fillRect(area, QBrush(rest_color, Qt::BDiagPattern));
    painter.setPen(QPen(rest_color, 1));
    painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

/// Marks the time of a run without the lines that its control refuses.
void hatch(QPainter& painter, const QRectF& area) {
  painter.fillRect(area, QBrush(refused_color, Qt::FDiagPattern));
}

std::optional<CauseKind> kind_of(const BarPart& part) {
  return part.cause ? std::optional(part.cause->kind) : std::nullopt;
}

/// What of a piece a text may fill so that the line at `x` does not cross it: the wider side.
QRectF clear_side(const QRectF& piece, double x) {
  if (x <= piece.left() || x >= piece.right()) {
    return piece;
  }
  QRectF side = piece;
  if (x - piece.left() > piece.right() - x) {
    side.setRight(x);
  } else {
    side.setLeft(x);
  }
  return side;
}

/// "X 35 %" where there is room, else "X" or nothing; no axis where none sets it.
void draw_share(QPainter& painter, const BarPart& part, double cycle_time, const QRectF& room) {
  if (room.height() < min_bar_with_text) {
    return;
  }
  const bool has_axis = part.cause && part.cause->axis >= 0;
  const QString axis = has_axis ? QString(QChar(axis_name(*part.cause))) : QString();
  const QString share =
      ComparisonChart::tr("%1 %").arg(QLocale().toString(100 * part.time / cycle_time, 'f', 0));
  painter.setPen(part.cause ? text_on(color_of(part.cause->kind)) : text_color);
  const QFontMetricsF metrics(painter.font());
  for (const QString& text : {has_axis ? axis + ' ' + share : share, axis}) {
    if (metrics.horizontalAdvance(text) + text_room <= room.width()) {
      painter.drawText(room, Qt::AlignCenter, text);
      return;
    }
  }
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
  draw_title(painter, layout);
  draw_legend(painter, layout);
  draw_axis(painter, layout);
  draw_columns(painter, layout);
  draw_bars(painter, layout);
  draw_machines(painter, layout);
}

void ComparisonChart::draw_title(QPainter& painter, const ComparisonLayout& layout) const {
  const QFont bold = sized(font(), title_size, true);
  const QFontMetricsF bold_metrics(bold);
  const QFontMetricsF metrics(font());
  const QRectF& area = layout.title;
  const double details_width = std::min(metrics.horizontalAdvance(details_), area.width() / 2);
  const double room = area.width() - details_width - 2 * label_gap;
  const QString title = bold_metrics.elidedText(title_, Qt::ElideMiddle, room);
  painter.setFont(bold);
  painter.setPen(text_color);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, title);
  painter.setFont(font());
  const double left = area.left() + bold_metrics.horizontalAdvance(title) + 2 * label_gap;
  const double top = area.top() + bold_metrics.ascent() - metrics.ascent();
  painter.drawText(QRectF(left, top, area.right() - left, metrics.height()), Qt::AlignLeft | Qt::AlignTop,
                   metrics.elidedText(details_, Qt::ElideRight, area.right() - left));
}

void ComparisonChart::draw_legend(QPainter& painter, const ComparisonLayout& layout) const {
  const QFontMetricsF metrics(font());
  for (std::size_t i = 0; i < layout.legend.size(); ++i) {
    const QRectF& entry = layout.legend[i];
    const QRectF square(entry.left(), entry.center().y() - swatch / 2, swatch, swatch);
    if (i + 1 == layout.legend.size()) {
      draw_programmed_time(painter, square.center().x(), square.top() - 2, square.bottom() + 2);
    } else if (i < bars_.kinds.size()) {
      fill_part(painter, square, bars_.kinds[i]);
    } else if (i == bars_.kinds.size() && bars_.rest) {
      fill_part(painter, square, std::nullopt);
    } else {
      painter.fillRect(square, axis_color);
      hatch(painter, square);
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
    grid.upright(layout.x_of(layout.ticks.values[i]), tick_text(layout.ticks, i),
                 i == 0 ? GridLine::strong : GridLine::usual);
  }
  painter.setPen(text_color);
  painter.drawText(QRectF(plot.left(), plot.bottom() + 5 + line, plot.width(), line),
                   Qt::AlignHCenter | Qt::AlignTop, tr("Time [s]"));
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
    const QString time = tr("programmed time %1 s").arg(seconds_text(machine.programmed_time, bars_));
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
      double time = 0;
      for (const BarPart& part : bar.parts) {
        const double left = layout.x_of(time);
        time += part.time;
        const QRectF piece(left, top, layout.x_of(time) - left, layout.bar_height);
        fill_part(painter, piece, kind_of(part));
        if (bar.lines_not_run > 0) {
          hatch(painter, piece);
        }
        if (left > layout.plot.left() && piece.width() > separated) {
          painter.setPen(QPen(Qt::white, 1));
          painter.drawLine(piece.topLeft(), piece.bottomLeft());
        }
        draw_share(painter, part, bar.cycle_time, clear_side(piece, programmed));
      }
    }
  }
}

}  // namespace feedscope::ui
