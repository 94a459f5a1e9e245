#include "ui/identification/residual_plot.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/ticks.h"
#include "ui/language/core_texts.h"
#include "ui/theme/type_size.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {
namespace {

struct Residuals {
  Q_DECLARE_TR_FUNCTIONS(ResidualPlot)
};

constexpr double edge = 6;    // around everything [pixels]
constexpr double mark = 22;   // of the legend, with its distance from the text [pixels]
constexpr double apart = 14;  // between entries of the legend [pixels]
constexpr double milliseconds = 1000;

/// Curves differ in style as well as in colour.
constexpr std::array<Qt::PenStyle, 4> pens{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

std::vector<QPointF> lag_of(const Agreement& agreement) {
  std::vector<QPointF> points{{0, 0}};
  for (const AgreementCell& cell : agreement.cells) {
    points.push_back(points.back() + QPointF(cell.measured_time, cell.simulated_time - cell.measured_time));
  }
  return points;
}

std::vector<QPointF> differences_of(const std::vector<SectionAgreement>& sections) {
  std::vector<QPointF> points;
  for (const SectionAgreement& section : sections) {
    points.emplace_back(static_cast<double>(points.size() + 1),
                        section.simulated_time - section.measured_time);
  }
  return points;
}

}  // namespace

std::vector<ResidualCurves> residual_curves(const IdentificationOutcome& outcome, std::size_t chosen) {
  std::vector<ResidualCurves> all;
  for (std::size_t i = 0; i < outcome.recordings.size(); ++i) {
    ResidualCurves curves{outcome.recordings[i].name, outcome.recordings[i].is_table, {}};
    for (std::size_t model = 0; model < outcome.models.size(); ++model) {
      const Identification& found = outcome.models[model];
      curves.models.push_back(
          {core_text(found.setup.model->info().title), run_colour(model),
           curves.of_sections ? differences_of(found.sections[i]) : lag_of(found.agreements[i])});
    }
    if (chosen < curves.models.size()) {
      const auto first = curves.models.begin();
      const auto one = first + static_cast<std::ptrdiff_t>(chosen);
      std::rotate(first, one, one + 1);
    }
    all.push_back(std::move(curves));
  }
  return all;
}

ResidualPlot::ResidualPlot(const ResidualCurves& curves, const QRectF& area, const QFont& font,
                           const ThemeColours& colours)
    : curves_(curves), font_(font), colours_(colours), area_(area), line_(QFontMetricsF(font).height()) {
  lay_out_legend(area);
  choose_scales();
  const double under_titles = legend_.empty() ? area.top() + edge + line_ : legend_.back().bottom();
  const double beside = QFontMetricsF(font).horizontalAdvance(QStringLiteral("−0.0000"));
  plot_ = QRectF(QPointF(area.left() + edge + beside, under_titles + 6),
                 QPointF(area.right() - 2 * edge, area.bottom() - 2 * line_ - 10));
  plot_.setWidth(std::max(plot_.width(), 40.0));
  plot_.setHeight(std::max(plot_.height(), 30.0));
}

/// Not needed for one model.
void ResidualPlot::lay_out_legend(const QRectF& area) {
  if (curves_.models.size() < 2) {
    return;
  }
  const double room = area.width() - 2 * edge;
  std::vector<double> widths;
  for (const ResidualCurve& curve : curves_.models) {
    widths.push_back(std::min(room, mark + QFontMetricsF(font_).horizontalAdvance(curve.name) + 2));
  }
  legend_ = entries_in_rows(widths, QRectF(area.left() + edge, area.top() + edge + line_ + 2, room, line_),
                            line_, line_ + 1, apart);
}

void ResidualPlot::choose_scales() {
  constexpr double farthest = 4;  // limit for other models, times the chosen model
  constexpr double least = 1e-4;  // [s]
  constexpr double most = 1e9;    // of a drawn value [s]
  constexpr double head_room = 0.08;
  double bound = most;
  for (const ResidualCurve& curve : curves_.models) {
    for (const QPointF& point : curve.points) {
      lowest_ = std::min(lowest_, std::max(point.y(), -bound));
      highest_ = std::max(highest_, std::min(point.y(), bound));
    }
    if (bound == most) {
      bound = farthest * std::max({-lowest_, highest_, least});
    }
  }
  if (!curves_.models.empty() && !curves_.models.front().points.empty()) {
    last_ = std::clamp(curves_.models.front().points.back().x(), least, most);
  }
  if (curves_.of_sections) {
    first_ = 0.5;
    last_ += 0.5;
  }
  const double room = std::max(head_room * (highest_ - lowest_), least);
  lowest_ -= room;
  highest_ += room;
}

QPointF ResidualPlot::place_of(const QPointF& point) const {
  constexpr double farthest = 1e4;  // from the plot, against extreme values of a file [pixels]
  const double x = (point.x() - first_) / (last_ - first_) * plot_.width();
  const double y = (point.y() - lowest_) / (highest_ - lowest_) * plot_.height();
  return {plot_.left() + std::clamp(x, -farthest, farthest),
          plot_.bottom() - std::clamp(y, -farthest, farthest)};
}

bool ResidualPlot::in_milliseconds() const {
  return std::max(-lowest_, highest_) < 1;
}

void ResidualPlot::draw(QPainter& painter) const {
  painter.save();
  painter.setFont(font_);
  draw_titles(painter);
  draw_legend(painter);
  draw_scales(painter);
  painter.setClipRect(plot_.adjusted(-1, -1, 1, 1), Qt::IntersectClip);
  for (std::size_t model = curves_.models.size(); model-- > 0;) {
    curves_.of_sections ? draw_bars(painter, model) : draw_curve(painter, model);
  }
  painter.restore();
}

void ResidualPlot::draw_titles(QPainter& painter) const {
  const QRectF above(area_.left() + edge, area_.top() + edge, area_.width() - 2 * edge, line_);
  const QString title = in_milliseconds() ? Residuals::tr("Simulated − recorded [ms]")
                                          : Residuals::tr("Simulated − recorded [s]");
  const QFontMetricsF metrics(font_);
  painter.setPen(colours_.text);
  painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter, title);
  const double room = above.width() - metrics.horizontalAdvance(title) - apart;
  painter.drawText(above, Qt::AlignRight | Qt::AlignVCenter,
                   metrics.elidedText(curves_.recording, Qt::ElideMiddle, room));
  painter.drawText(QRectF(plot_.left(), area_.bottom() - line_ - 3, plot_.width(), line_), Qt::AlignCenter,
                   curves_.of_sections ? Residuals::tr("Section, by row of the table")
                                       : Residuals::tr("Recorded time [s]"));
}

void ResidualPlot::draw_legend(QPainter& painter) const {
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    const QRectF& entry = legend_[i];
    const QColor& colour = curves_.models[i].colour;
    const QPointF left(entry.left(), entry.center().y());
    const QPointF right(entry.left() + mark - 4, entry.center().y());
    if (curves_.of_sections) {
      painter.fillRect(QRectF(left - QPointF(0, 4), right + QPointF(0, 4)), colour);
    } else {
      painter.setPen(QPen(colour, line_pixels(i == 0 ? 2.4 : 1.6), pens[i % pens.size()], Qt::FlatCap));
      painter.drawLine(left, right);
    }
    painter.setPen(colours_.text);
    painter.drawText(
        entry.adjusted(mark, 0, 2, 0), Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetricsF(font_).elidedText(curves_.models[i].name, Qt::ElideRight, entry.width() - mark + 2));
  }
}

void ResidualPlot::draw_scales(QPainter& painter) const {
  const double factor = in_milliseconds() ? milliseconds : 1;
  const int rows = std::clamp(static_cast<int>(plot_.height() / (2 * line_)), 2, 8);
  PlotGrid grid(painter, plot_, {colours_.grid, colours_.frame, colours_.text, 6, 5});
  const Ticks levels = round_ticks(factor * lowest_, factor * highest_, rows);
  for (std::size_t i = 0; i < levels.values.size(); ++i) {
    const double value = levels.values[i];
    grid.level(place_of({first_, value / factor}).y(), tick_text(levels, i),
               value == 0 ? GridLine::strong : GridLine::usual);
  }
  const double label = QFontMetricsF(font_).horizontalAdvance(QStringLiteral("00000")) + 10;
  const Ticks times = round_ticks(first_, last_, std::clamp(static_cast<int>(plot_.width() / label), 2, 12));
  for (std::size_t i = 0; i < times.values.size(); ++i) {
    const double value = times.values[i];
    if (!curves_.of_sections || value == std::round(value)) {
      grid.upright(place_of({value, 0}).x(), tick_text(times, i));
    }
  }
}

void ResidualPlot::draw_curve(QPainter& painter, std::size_t model) const {
  QPolygonF line;
  for (const QPointF& point : curves_.models[model].points) {
    line << place_of(point);
  }
  painter.setPen(QPen(curves_.models[model].colour, line_pixels(model == 0 ? 2 : 1.4),
                      pens[model % pens.size()], Qt::FlatCap));
  painter.drawPolyline(line);
}

/// Draws one bar for each section; those of the other models are next to it.
void ResidualPlot::draw_bars(QPainter& painter, std::size_t model) const {
  constexpr double share = 0.8;  // of the width of a section that its bars take
  const double width = share / static_cast<double>(curves_.models.size());
  for (const QPointF& point : curves_.models[model].points) {
    const double left = point.x() - share / 2 + static_cast<double>(model) * width;
    painter.fillRect(QRectF(place_of({left, 0}), place_of({left + width, point.y()})).normalized(),
                     curves_.models[model].colour);
  }
}

}  // namespace feedscope::ui
