#include "ui/charts/curve_columns.h"

#include <QPainter>
#include <QPolygonF>
#include <QVarLengthArray>
#include <algorithm>
#include <cmath>
#include <vector>

namespace feedscope::ui {

namespace {

constexpr double min_overlap = 2;         // [px] of neighbouring columns with oscillation
constexpr double swinging_overlap = 0.4;  // of the lower of the two
constexpr std::size_t min_swinging = 4;
constexpr double min_hollow = 6;  // [px] between two edges
constexpr double jump = 8;        // columns of this height in widths are filled as a whole
constexpr std::size_t dash_period = 10;
constexpr std::size_t dash_length = 6;

/// Extends neighbouring columns to meet half way, like the curve between them.
std::vector<ColumnSpan> joined(std::span<const ColumnSpan> columns) {
  std::vector<ColumnSpan> spans(columns.begin(), columns.end());
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
    if (columns[i].empty() || columns[i + 1].empty()) {
      continue;
    }
    if (columns[i].bottom < columns[i + 1].top) {
      const double middle = (columns[i].bottom + columns[i + 1].top) / 2;
      spans[i].bottom = std::max(spans[i].bottom, middle);
      spans[i + 1].top = std::min(spans[i + 1].top, middle);
    } else if (columns[i + 1].bottom < columns[i].top) {
      const double middle = (columns[i + 1].bottom + columns[i].top) / 2;
      spans[i].top = std::min(spans[i].top, middle);
      spans[i + 1].bottom = std::max(spans[i + 1].bottom, middle);
    }
  }
  return spans;
}

double overlap_of(const ColumnSpan& a, const ColumnSpan& b) {
  return std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
}

bool swings(const ColumnSpan& a, const ColumnSpan& b) {
  return overlap_of(a, b) > std::max(min_overlap, swinging_overlap * std::min(a.height(), b.height()));
}

/// Drawn part of a curve.
enum class CurvePart { all, edges, inside };

class ColumnPainter {
 public:
  ColumnPainter(QPainter& painter, const QRectF& plot, std::vector<ColumnSpan> spans, double width,
                CurvePart part)
      : painter_(painter),
        plot_(plot),
        spans_(std::move(spans)),
        column_(plot.width() / static_cast<double>(spans_.size())),
        half_width_(width / 2),
        part_(part) {}

  /// Draws columns [first, end), none of them empty.
  void draw(std::size_t first, std::size_t end) const {
    for (std::size_t i = first; i < end;) {
      std::size_t swinging = i;
      while (swinging + 1 < end && swings(spans_[swinging], spans_[swinging + 1])) {
        ++swinging;
      }
      if (swinging - i >= min_swinging) {
        fill_each(i, swinging + 1);
        i = swinging;
        if (i + 1 >= end) {
          return;
        }
      }
      std::size_t last = i + 1;
      while (last < end && !begins_swinging(last, end)) {
        ++last;
      }
      fill_band(i, std::min(last + 1, end));
      i = last;
    }
  }

 private:
  bool begins_swinging(std::size_t i, std::size_t end) const {
    for (std::size_t k = 0; k < min_swinging; ++k) {
      if (i + k + 1 >= end || !swings(spans_[i + k], spans_[i + k + 1])) {
        return false;
      }
    }
    return true;
  }

  double left_of(std::size_t i) const { return plot_.left() + static_cast<double>(i) * column_; }

  void fill_each(std::size_t first, std::size_t end) const {
    QVarLengthArray<QRectF, 1024> columns;
    for (std::size_t i = first; i < end; ++i) {
      const double height = spans_[i].height();
      const bool hollow = part_ != CurvePart::all && height > min_hollow + 2 * half_width_;
      if (!hollow && part_ != CurvePart::inside) {
        columns.append(QRectF(left_of(i), spans_[i].top - half_width_, column_, height + 2 * half_width_));
      } else if (part_ == CurvePart::edges) {
        columns.append(QRectF(left_of(i), spans_[i].top - half_width_, column_, 2 * half_width_));
        columns.append(QRectF(left_of(i), spans_[i].bottom - half_width_, column_, 2 * half_width_));
      } else if (hollow) {
        columns.append(QRectF(left_of(i), spans_[i].top, column_, height));
      }
    }
    painter_.drawRects(columns.constData(), static_cast<int>(columns.size()));
  }

  /// Extension of the span upwards and downwards that makes a slanted line as thick as a level one.
  double padding(const ColumnSpan& span) const {
    const double steepness = span.height() / column_;
    const double even = half_width_ * std::hypot(1, steepness) - span.height() / 2;
    return std::clamp(even, std::min(half_width_, column_ / 2), 2 * half_width_);
  }

  void fill_band(std::size_t first, std::size_t end) const {
    if (part_ == CurvePart::inside) {
      return;
    }
    QPolygonF outline;
    outline.reserve(2 * static_cast<qsizetype>(end - first) + 4);
    const auto add = [&](std::size_t i, double x, bool upper) {
      const double pad = padding(spans_[i]);
      outline.append({x, upper ? spans_[i].top - pad : spans_[i].bottom + pad});
    };
    add(first, left_of(first), true);
    for (std::size_t i = first; i < end; ++i) {
      add(i, left_of(i) + column_ / 2, true);
    }
    add(end - 1, left_of(end), true);
    add(end - 1, left_of(end), false);
    for (std::size_t i = end; i-- > first;) {
      add(i, left_of(i) + column_ / 2, false);
    }
    add(first, left_of(first), false);
    painter_.drawPolygon(outline);
    for (std::size_t i = first; i < end; ++i) {
      if (spans_[i].height() > jump * column_) {
        painter_.drawRect(QRectF(left_of(i), spans_[i].top, column_, spans_[i].height()));
      }
    }
  }

  QPainter& painter_;
  QRectF plot_;
  std::vector<ColumnSpan> spans_;
  double column_;
  double half_width_;
  CurvePart part_;
};

void draw_part(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
               const CurvePen& pen, CurvePart part) {
  if (columns.empty()) {
    return;
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(pen.color);
  const ColumnPainter columns_painter(painter, plot, joined(columns), pen.width, part);
  std::size_t first = 0;
  for (std::size_t i = 0; i <= columns.size(); ++i) {
    const bool gap =
        i == columns.size() || columns[i].empty() || (pen.dashed && i % dash_period >= dash_length);
    if (gap) {
      if (i > first) {
        columns_painter.draw(first, i);
      }
      first = i + 1;
    }
  }
}

}  // namespace

bool hidden_in_bars(std::span<const ColumnSpan> columns) {
  constexpr double least_height = 4;  // [px] that neighbours share
  constexpr double least_share = 0.3;
  double covered = 0;
  std::size_t pairs = 0;
  std::vector<double> tops;
  std::vector<double> bottoms;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) {
      continue;
    }
    tops.push_back(columns[i].top);
    bottoms.push_back(columns[i].bottom);
    if (i + 1 < columns.size() && !columns[i + 1].empty()) {
      covered += std::max(0.0, overlap_of(columns[i], columns[i + 1]));
      ++pairs;
    }
  }
  if (pairs == 0) {
    return false;
  }
  constexpr std::size_t twentieths = 20;
  const auto upper = tops.begin() + static_cast<std::ptrdiff_t>(tops.size() / twentieths);
  const auto lower = bottoms.end() - 1 - static_cast<std::ptrdiff_t>(bottoms.size() / twentieths);
  std::ranges::nth_element(tops, upper);
  std::ranges::nth_element(bottoms, lower);
  return covered > static_cast<double>(pairs) * std::max(least_height, least_share * (*lower - *upper));
}

double mean_height(std::span<const ColumnSpan> columns) {
  double sum = 0;
  std::size_t count = 0;
  for (const ColumnSpan& column : columns) {
    sum += column.empty() ? 0 : column.height();
    count += column.empty() ? 0 : 1;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

void draw_columns(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
                  const CurvePen& pen) {
  draw_part(painter, plot, columns, pen, pen.hollow ? CurvePart::edges : CurvePart::all);
}

void fill_hollows(QPainter& painter, const QRectF& plot, std::span<const ColumnSpan> columns,
                  const CurvePen& pen) {
  draw_part(painter, plot, columns, pen, CurvePart::inside);
}

}  // namespace feedscope::ui
