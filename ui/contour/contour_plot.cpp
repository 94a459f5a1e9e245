#include "ui/charts/contour_plot.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/scene/ticks.h"

namespace feedscope::ui {

namespace {

struct Plot {
  Q_DECLARE_TR_FUNCTIONS(ContourPlot)
};

constexpr double margin = 8;
constexpr double swatch = 18;
constexpr double gap = 14;
constexpr double micrometres = 1000;
/// Outlines are told apart without colour.
constexpr std::array<Qt::PenStyle, 4> styles{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

QString number(double value) {
  return QLocale().toString(value, 'g', 3);
}

/// 0.001, 10 000.
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
  for (double power = least_length_; power <= most_length_ * 1.001; power *= 10) {
    left = std::max(left, text_width(font_, power_text(power)));
  }
  const double rows = curves.sides ? 3 : 2;
  plot_ = QRectF(area.left() + margin + left + 6, top, 0, 0);
  plot_.setRight(std::max(area.right() - 2 * margin, plot_.left() + 40));
  plot_.setBottom(std::max(area.bottom() - rows * line_ - 10, plot_.top() + 30));
}

QString ContourPlot::entry_text(std::size_t run, double room) const {
  const ContourCurve& curve = curves_.runs[run];
  const QString largest = number(micrometres * curve.largest);
  const double beside = curve.largest_beside();
  constexpr double most_of_it = 0.9;
  const QString error = curves_.sides && beside < most_of_it * curve.largest
                            ? Plot::tr(": %1 µm, in XY %2 µm").arg(largest, number(micrometres * beside))
                            : Plot::tr(": %1 µm").arg(largest);
  return QFontMetricsF(font_).elidedText(curve.name, Qt::ElideRight,
                                         std::max(room - swatch - text_width(font_, error), 20.0)) +
         error;
}

/// One run needs none.
void ContourPlot::lay_out_legend(const QRectF& area) {
  if (curves_.runs.size() < 2) {
    return;
  }
  const double room = area.width() - 2 * margin;
  double left = area.left() + margin;
  double top = area.top() + 4;
  for (std::size_t i = 0; i < curves_.runs.size(); ++i) {
    const double width = std::min(room, swatch + 4 + text_width(font_, entry_text(i, room)));
    if (left > area.left() + margin && left + width > area.right() - margin) {
      left = area.left() + margin;
      top += line_ + 1;
    }
    legend_.emplace_back(left, top, width, line_);
    left += width + gap;
  }
}

void ContourPlot::choose_scales() {
  constexpr double most_decades = 1e6;
  double most = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const ContourHistogram& histogram : histograms_) {
    for (const double length : histogram.length) {
      most = std::max(most, length);
      least = length > 0 ? std::min(least, length) : least;
    }
  }
  double farthest = 0;  // of what is there at all: sides leave out what lies across Z
  for (const ContourHistogram& histogram : histograms_) {
    for (std::size_t i = 0; i < histogram.length.size(); ++i) {
      if (histogram.length[i] > 0) {
        farthest = std::max({farthest, std::abs(histogram.edges[i]), std::abs(histogram.edges[i + 1])});
      }
    }
  }
  if (most > 0) {
    most_length_ = std::pow(10, std::ceil(std::log10(most) - 1e-9));
    least = std::max(least, most_length_ / most_decades);
    least_length_ = std::min(std::pow(10, std::floor(std::log10(least))), most_length_ / 10);
    most_error_ = farthest;
  }
  constexpr double worth_showing = 2.5;  // times the largest error
  if (curves_.tolerance && (*curves_.tolerance)[0] < worth_showing * most_error_) {
    constexpr double head_room = 1.05;
    most_error_ =
        std::max(most_error_, std::min((*curves_.tolerance)[1], worth_showing * most_error_) * head_room);
  }
}

double ContourPlot::x(double error) const {
  return curves_.sides ? plot_.center().x() - error / most_error_ * plot_.width() / 2
                       : plot_.left() + error / most_error_ * plot_.width();
}

double ContourPlot::y(double length) const {
  if (length <= least_length_) {
    return plot_.bottom();
  }
  const double share = std::log(length / least_length_) / std::log(most_length_ / least_length_);
  return plot_.bottom() - share * plot_.height();
}

QRectF ContourPlot::below(double rows) const {
  return {plot_.left(), plot_.bottom() + 5 + rows * line_, plot_.width(), line_};
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
      painter.setPen(QPen(run.colour, 2, styles[(i - 1) % styles.size()]));
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
                   Qt::AlignLeft | Qt::AlignVCenter, Plot::tr("Path length [mm]"));
  double free = plot_.bottom() + line_;
  for (double power = least_length_; power <= most_length_ * 1.001; power *= 10) {
    const double at = std::round(y(power)) + 0.5;
    painter.setPen(QPen(colours_.grid, 1));
    painter.drawLine(QPointF(plot_.left(), at), QPointF(plot_.right(), at));
    if (at + line_ / 2 <= free) {
      painter.setPen(colours_.text);
      painter.drawText(QRectF(plot_.left() - 206, at - line_ / 2, 200, line_),
                       Qt::AlignRight | Qt::AlignVCenter, power_text(power));
      free = at - line_ / 2;
    }
  }
}

void ContourPlot::draw_errors(QPainter& painter) const {
  const double label = text_width(font_, QStringLiteral("0000")) + 10;
  const double most = most_error_ * micrometres;
  const int count = static_cast<int>(std::clamp(plot_.width() / label, 3.0, 13.0));
  const Ticks ticks = round_ticks(curves_.sides ? -most : 0, most, count);
  for (const double tick : ticks.values) {
    const double at = std::round(x(tick / micrometres)) + 0.5;
    painter.setPen(QPen(tick == 0 ? colours_.frame : colours_.grid, 1));
    painter.drawLine(QPointF(at, plot_.top()), QPointF(at, plot_.bottom() + 4));
    painter.setPen(colours_.text);
    painter.drawText(QRectF(at - 60, below(0).top(), 120, line_), Qt::AlignHCenter | Qt::AlignVCenter,
                     number(std::abs(tick)));
  }
  painter.setPen(QPen(colours_.frame, 1));
  painter.drawLine(plot_.bottomLeft(), plot_.bottomRight());
  painter.setPen(colours_.text);
  painter.drawText(below(curves_.sides ? 2 : 1).adjusted(-30, 0, 8, 0), Qt::AlignHCenter | Qt::AlignVCenter,
                   Plot::tr("Contour error [µm]"));
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
  if (!line.empty()) {  // down where the run's errors end
    line.prepend(QPointF(line.first().x(), plot_.bottom()));
    line.append(QPointF(line.last().x(), plot_.bottom()));
  }
  painter.setPen(QPen(curves_.runs[run].colour, 1.8, styles[(run - 1) % styles.size()], Qt::FlatCap));
  painter.drawPolyline(line);
}

void ContourPlot::draw_tolerance(QPainter& painter) const {
  if (!curves_.tolerance) {
    return;
  }
  const auto [least, largest] = *curves_.tolerance;
  const QString amount = least == largest ? number(micrometres * least)
                                          : QStringLiteral("%1 – %2").arg(number(micrometres * least),
                                                                          number(micrometres * largest));
  const bool is_outside = least > most_error_;
  const QString text =
      is_outside ? Plot::tr("tolerance %1 µm ▸").arg(amount) : Plot::tr("tolerance %1 µm").arg(amount);
  painter.setPen(QPen(colours_.text, 1.4, Qt::DashLine));
  double label_at = plot_.right();
  for (const double sign : {1.0, -1.0}) {
    for (const double tolerance : {least, largest}) {
      if (tolerance <= most_error_ && (sign > 0 || curves_.sides)) {
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
