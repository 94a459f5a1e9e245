#include "ui/contour/contour_plot.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/ticks.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

struct Plot {
  Q_DECLARE_TR_FUNCTIONS(ContourPlot)
};

constexpr double margin = 8;
constexpr double swatch = 18;
constexpr double gap = 14;
/// Outlines differ in style as well as in colour.
constexpr std::array<Qt::PenStyle, 4> styles{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

QString number(double value) {
  return QLocale().toString(value, 'g', 3);
}

/// Text of a power of ten: 0.001, 10 000.
QString power_text(double power) {
  return QLocale().toString(power, 'f', std::max(0, static_cast<int>(-std::floor(std::log10(power) + 0.5))));
}

double text_width(const QFont& font, const QString& text) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

}  // namespace

double ContourCurve::largest_beside() const {
  double beside = 0;
  for (const std::vector<double>* side : {&spread.left, &spread.right}) {
    const auto last =
        std::ranges::find_if(side->rbegin(), side->rend(), [](double length) { return length > 0; });
    beside = std::max(beside, static_cast<double>(side->rend() - last) * spread.step);
  }
  return std::min(beside, largest);
}

double ContourCurves::largest() const {
  double largest = 0;
  for (const ContourCurve& run : runs) {
    largest = std::max(largest, run.largest);
  }
  return largest;
}

double ContourCurves::extent() const {
  if (!sides) {
    return largest();
  }
  double extent = 0;
  for (const ContourCurve& run : runs) {
    constexpr double fewest_steps = 200;  // so that bins are whole steps wide
    extent = std::max({extent, fewest_steps * run.spread.step, run.largest_beside()});
  }
  return std::min(extent, largest());
}

ContourHistogram ContourCurves::histogram(std::size_t run) const {
  return histogram_of(runs[run].spread, sides ? ContourBins::sides : ContourBins::amounts, extent());
}

ContourPlot::ContourPlot(const ContourCurves& curves, const QRectF& area, const QFont& font,
                         const ThemeColours& colours)
    : curves_(curves), font_(font), colours_(colours), line_(QFontMetricsF(font).height()) {
  for (std::size_t i = 0; i < curves.runs.size(); ++i) {
    histograms_.push_back(curves.histogram(i));
  }
  lay_out_legend(area);
  choose_scales();
  const double top = area.top() + margin + (legend_.empty() ? 0 : legend_.back().bottom() - area.top()) +
                     line_ + 4 + (curves.tolerance ? line_ : 0);
  double left = 0;
  for (double power = min_length_; power <= max_length_ * 1.001; power *= 10) {
    left = std::max(left, text_width(font_, power_text(power)));
  }
  const double rows = curves.sides ? 3 : 2;
  plot_ = QRectF(area.left() + margin + left + 6, top, 0, 0);
  plot_.setRight(std::max(area.right() - 2 * margin, plot_.left() + 40));
  plot_.setBottom(std::max(area.bottom() - rows * line_ - 10, plot_.top() + 30));
}

QString ContourPlot::entry_text(std::size_t run, double room) const {
  const ContourCurve& curve = curves_.runs[run];
  const auto amount = [](double error) {
    return number(in_shown_unit(error, Dimension::error)) + ' ' + unit_of(Dimension::error);
  };
  const double beside = curve.largest_beside();
  constexpr double most_of_it = 0.9;
  const QString error = curves_.sides && beside < most_of_it * curve.largest
                            ? Plot::tr(": %1, in XY %2").arg(amount(curve.largest), amount(beside))
                            : Plot::tr(": %1").arg(amount(curve.largest));
  return QFontMetricsF(font_).elidedText(curve.name, Qt::ElideRight,
                                         std::max(room - swatch - text_width(font_, error), 20.0)) +
         error;
}

/// Not needed for one run.
void ContourPlot::lay_out_legend(const QRectF& area) {
  if (curves_.runs.size() < 2) {
    return;
  }
  const double room = area.width() - 2 * margin;
  std::vector<double> widths;
  for (std::size_t i = 0; i < curves_.runs.size(); ++i) {
    widths.push_back(std::min(room, swatch + 4 + text_width(font_, entry_text(i, room))));
  }
  legend_ = entries_in_rows(widths, QRectF(area.left() + margin, area.top() + 4, room, line_), line_,
                            line_ + 1, gap);
}

void ContourPlot::choose_scales() {
  constexpr double max_decades = 1e6;
  double most = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const ContourHistogram& histogram : histograms_) {
    for (const double length : histogram.length) {
      most = std::max(most, length);
      least = length > 0 ? std::min(least, length) : least;
    }
  }
  double farthest = 0;  // of all errors: sides omit the part along Z
  for (const ContourHistogram& histogram : histograms_) {
    for (std::size_t i = 0; i < histogram.length.size(); ++i) {
      if (histogram.length[i] > 0) {
        farthest = std::max({farthest, std::abs(histogram.edges[i]), std::abs(histogram.edges[i + 1])});
      }
    }
  }
  if (most > 0) {
    max_length_ = std::pow(10, std::ceil(std::log10(most) - 1e-9));
    least = std::max(least, max_length_ / max_decades);
    min_length_ = std::min(std::pow(10, std::floor(std::log10(least))), max_length_ / 10);
    max_error_ = farthest;
  }
  constexpr double worth_showing = 2.5;  // times the largest error
  if (curves_.tolerance && (*curves_.tolerance)[0] < worth_showing * max_error_) {
    constexpr double head_room = 1.05;
    max_error_ =
        std::max(max_error_, std::min((*curves_.tolerance)[1], worth_showing * max_error_) * head_room);
  }
}

double ContourPlot::x(double error) const {
  return curves_.sides ? plot_.center().x() - error / max_error_ * plot_.width() / 2
                       : plot_.left() + error / max_error_ * plot_.width();
}

double ContourPlot::y(double length) const {
  if (length <= min_length_) {
    return plot_.bottom();
  }
  const double share = std::log(length / min_length_) / std::log(max_length_ / min_length_);
  return plot_.bottom() - share * plot_.height();
}

QRectF ContourPlot::below(double rows) const {
  return {plot_.left(), plot_.bottom() + 5 + rows * line_, plot_.width(), line_};
}

GridLook ContourPlot::grid_look() const {
  return {colours_.grid, colours_.frame, colours_.text, 6, 5};
}

void ContourPlot::draw(QPainter& painter) const {
  painter.save();
  painter.setFont(font_);
  draw_legend(painter);
  draw_lengths(painter);
  draw_errors(painter);
  draw_bars(painter);
  for (std::size_t i = 1; i < histograms_.size(); ++i) {
    draw_outline(painter, i);
  }
  draw_tolerance(painter);
  draw_sides(painter);
  painter.restore();
}

void ContourPlot::draw_legend(QPainter& painter) const {
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    const QRectF& entry = legend_[i];
    const ContourCurve& run = curves_.runs[i];
    const QRectF mark(entry.left(), entry.center().y() - 4, swatch - 4, 8);
    if (i == 0) {
      painter.fillRect(mark, run.colour);
    } else {
      painter.setPen(QPen(run.colour, line_pixels(2), styles[(i - 1) % styles.size()]));
      painter.drawLine(QPointF(mark.left(), mark.center().y()), QPointF(mark.right(), mark.center().y()));
    }
    painter.setPen(colours_.text);
    painter.drawText(entry.adjusted(swatch, 0, 4, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     entry_text(i, entry.width() + 1));
  }
}

void ContourPlot::draw_lengths(QPainter& painter) const {
  painter.setPen(colours_.text);
  const double title_top = plot_.top() - 4 - line_ - (curves_.tolerance ? line_ : 0);
  painter.drawText(QRectF(plot_.left() - 4, title_top, plot_.width() + 8, line_),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   with_unit_of(Plot::tr("Path length"), Dimension::length));
  PlotGrid grid(painter, plot_, grid_look());
  for (double power = min_length_; power <= max_length_ * 1.001; power *= 10) {
    grid.level(y(power), power_text(power));
  }
}

void ContourPlot::draw_errors(QPainter& painter) const {
  const double label = text_width(font_, QStringLiteral("0000")) + 10;
  const double most = in_shown_unit(max_error_, Dimension::error);
  const int count = static_cast<int>(std::clamp(plot_.width() / label, 3.0, 13.0));
  const Ticks ticks = round_ticks(curves_.sides ? -most : 0, most, count);
  PlotGrid grid(painter, plot_, grid_look());
  for (const double tick : ticks.values) {
    grid.upright(x(from_shown_unit(tick, Dimension::error)), number(std::abs(tick)),
                 tick == 0 ? GridLine::strong : GridLine::usual);
  }
  painter.setPen(QPen(colours_.frame, 1));
  painter.drawLine(plot_.bottomLeft(), plot_.bottomRight());
  painter.setPen(colours_.text);
  painter.drawText(below(curves_.sides ? 2 : 1).adjusted(-30, 0, 8, 0), Qt::AlignHCenter | Qt::AlignVCenter,
                   with_unit_of(Plot::tr("Contour error"), Dimension::error));
}

void ContourPlot::draw_sides(QPainter& painter) const {
  if (!curves_.sides) {
    return;
  }
  const QString left = Plot::tr("◂ left of the path");
  const QString right = Plot::tr("right of the path ▸");
  painter.setPen(colours_.text);
  painter.drawText(below(1), Qt::AlignLeft | Qt::AlignVCenter, left);
  painter.drawText(below(1), Qt::AlignRight | Qt::AlignVCenter, right);
}

QRectF ContourPlot::bar(std::size_t run, std::size_t bin) const {
  const ContourHistogram& histogram = histograms_[run];
  const ContourCurve& curve = curves_.runs[run];
  const double largest = curves_.sides ? curve.largest_beside() : curve.largest;
  const auto edge = [&](std::size_t i) { return x(std::clamp(histogram.edges[i], -largest, largest)); };
  const double top = std::min(y(histogram.length[bin]), plot_.bottom() - 1);
  return QRectF(QPointF(edge(bin), top), QPointF(edge(bin + 1), plot_.bottom())).normalized();
}

void ContourPlot::draw_bars(QPainter& painter) const {
  if (histograms_.empty()) {
    return;
  }
  const ContourHistogram& histogram = histograms_.front();
  QColor fill = curves_.runs.front().colour;
  constexpr float half_through = 0.55F;
  fill.setAlphaF(half_through);
  for (std::size_t i = 0; i < histogram.length.size(); ++i) {
    if (histogram.length[i] <= 0) {
      continue;
    }
    const QRectF bar = this->bar(0, i);
    painter.fillRect(bar, fill);
    const double beyond = std::min(std::abs(histogram.edges[i]), std::abs(histogram.edges[i + 1]));
    if (curves_.tolerance && beyond >= (*curves_.tolerance)[1] * (1 - 1e-9)) {
      painter.fillRect(bar, QBrush(colours_.text, Qt::BDiagPattern));
    }
    painter.setPen(QPen(curves_.runs.front().colour, 1));
    painter.drawRect(bar);
  }
}

void ContourPlot::draw_outline(QPainter& painter, std::size_t run) const {
  const ContourHistogram& histogram = histograms_[run];
  QPolygonF line;
  for (std::size_t i = 0; i < histogram.length.size(); ++i) {
    const QRectF step = bar(run, i);
    if (step.width() > 0) {
      line << (curves_.sides ? step.topRight() : step.topLeft())
           << (curves_.sides ? step.topLeft() : step.topRight());
    }
  }
  if (!line.empty()) {  // down to zero at the end of the run's errors
    line.prepend(QPointF(line.first().x(), plot_.bottom()));
    line.append(QPointF(line.last().x(), plot_.bottom()));
  }
  painter.setPen(
      QPen(curves_.runs[run].colour, line_pixels(1.8), styles[(run - 1) % styles.size()], Qt::FlatCap));
  painter.drawPolyline(line);
}

void ContourPlot::draw_tolerance(QPainter& painter) const {
  if (!curves_.tolerance) {
    return;
  }
  const auto [least, largest] = *curves_.tolerance;
  const auto text_of = [](double error) { return number(in_shown_unit(error, Dimension::error)); };
  const QString range =
      least == largest ? text_of(least) : QStringLiteral("%1 – %2").arg(text_of(least), text_of(largest));
  const QString amount = range + ' ' + unit_of(Dimension::error);
  const bool is_outside = least > max_error_;
  const QString text =
      is_outside ? Plot::tr("tolerance %1 ▸").arg(amount) : Plot::tr("tolerance %1").arg(amount);
  painter.setPen(QPen(colours_.text, line_pixels(1.4), Qt::DashLine));
  double label_at = plot_.right();
  for (const double sign : {1.0, -1.0}) {
    for (const double tolerance : {least, largest}) {
      if (tolerance <= max_error_ && (sign > 0 || curves_.sides)) {
        const double at = x(sign * tolerance);
        painter.drawLine(QPointF(at, plot_.top() - 2), QPointF(at, plot_.bottom()));
        label_at = at;
      }
    }
  }
  const double room = text_width(font_, text) + 2;
  const double left = std::clamp(label_at - room / 2, plot_.left(), plot_.right() + margin - room);
  painter.setPen(colours_.text);
  painter.drawText(QRectF(left, plot_.top() - line_ - 3, room, line_), Qt::AlignCenter, text);
}

std::optional<std::size_t> ContourPlot::bin_at(const QPointF& place) const {
  if (histograms_.empty() || !plot_.contains(place)) {
    return std::nullopt;
  }
  const std::vector<double>& edges = histograms_.front().edges;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const auto [left, right] = std::minmax({x(edges[i]), x(edges[i + 1])});
    if (place.x() >= left && place.x() < right) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace feedscope::ui
