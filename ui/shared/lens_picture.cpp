#include "ui/shared/lens_picture.h"

#include <QFont>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/ticks.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {
namespace {

constexpr double base_share = 0.36;  // of the height below the centre, from which the corner opens
constexpr double bar_share = 0.3;    // of a side, the largest length of its scale bar
constexpr double text_pixels = 12;
constexpr double title_pixels = 13;
constexpr double margin = 10;
constexpr double table_room = 300;  // smallest side of a lens with a table

/// The largest of 1, 2 and 5 times a power of ten up to `value`.
double round_down_125(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

/// Two or three significant digits, never with an exponent.
QString factor_text(double factor) {
  const double power = std::floor(std::log10(factor));
  const double last = std::pow(10, power - (factor < 100 ? 1 : 2));
  return QLocale().toString(last * std::round(factor / last), 'f',
                            static_cast<int>(std::clamp(1 - power, 0.0, 9.0)));
}

QFont font_of(QFont font, double pixels, bool bold = false) {
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(pixels))));
  font.setBold(bold);
  return font;
}

}  // namespace

/// The projection of the lens onto the picture.
struct LensPicture::View {
  QRectF whole;
  QRectF title;
  QRectF plot;
  QPalette palette;
  double along = 1;   ///< [pixels/mm]
  double across = 1;  ///< [pixels/mm]

  QPointF at(const LensPoint& point) const {
    return {plot.center().x() + along * point.x(),
            plot.bottom() - base_share * plot.height() - across * point.y()};
  }
  QColor ink(double strength) const {
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const auto mix = [&](int from, int to) {
      return static_cast<int>(std::lround(from + strength * (to - from)));
    };
    return {mix(ground.red(), text.red()), mix(ground.green(), text.green()),
            mix(ground.blue(), text.blue())};
  }
  /// Fades the drawing in `room` for text on top of it.
  void make_pale(QPainter& painter, const QRectF& room) const {
    constexpr double opacity = 0.8;
    QColor ground = palette.color(QPalette::Base);
    ground.setAlphaF(opacity);
    painter.fillRect(room, ground);
  }
};

LensPicture::LensPicture(const Lens& lens, std::vector<LensLook> looks, double scale)
    : lens_(lens), looks_(std::move(looks)), scale_(scale) {}

void LensPicture::paint(QPainter& painter, const QRectF& area, const QPalette& palette) const {
  View view;
  view.whole = area;
  view.palette = palette;
  view.title = QRectF(area.topLeft(), QSizeF(area.width(), (title_pixels + margin) * scale_));
  view.plot = QRectF(view.title.bottomLeft(), area.bottomRight());
  view.along = view.plot.width() / lens_.width;
  view.across = view.plot.height() / lens_.height;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  draw_title(painter, view);
  painter.save();
  painter.setClipRect(view.plot);
  draw_tolerance(painter, view);
  draw_paths(painter, view);
  painter.restore();
  draw_scales(painter, view);
  if (std::min(view.plot.width(), view.plot.height()) >= table_room * scale_) {
    draw_table(painter, view);
  }
  painter.restore();
}

void LensPicture::draw_title(QPainter& painter, const View& view) const {
  painter.setPen(view.ink(1));
  const QRectF inner = view.title.adjusted(margin * scale_, 0, -margin * scale_, 0);
  painter.setFont(font_of(painter.font(), title_pixels * scale_));
  const QFontMetricsF metrics(painter.font());
  const auto room_beside = [&](const QString& text) {
    return inner.width() - metrics.horizontalAdvance(text) - margin / 2 * scale_;
  };
  const QString line = tr("line %1").arg(lens_.line);
  const QString factor = factor_text(view.across / view.along);
  QString stretch = lens_.deviates ? tr("across × %1").arg(factor) : tr("no deviation");
  if (lens_.deviates && metrics.horizontalAdvance(line) > room_beside(stretch)) {
    stretch = QStringLiteral("× %1").arg(factor);
  }
  painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, stretch);
  const double room = room_beside(stretch);
  const QString whole = tr("Lens: line %1").arg(lens_.line);
  const QString title = metrics.horizontalAdvance(whole) <= room ? whole : line;
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(title, Qt::ElideRight, room));
  painter.setPen(QPen(view.ink(0.25), scale_));
  painter.drawLine(view.title.bottomLeft(), view.title.bottomRight());
}

/// Draws the tolerance on both sides of each segment of the programmed path. The lens is affine, so that
/// parallel lines stay parallel.
void LensPicture::draw_tolerance(QPainter& painter, const View& view) const {
  if (!(lens_.tolerance > 0)) {
    return;
  }
  painter.setPen(QPen(view.ink(0.3), scale_, Qt::DotLine));
  for (const double side : {-lens_.tolerance, lens_.tolerance}) {
    for (const std::vector<LensPoint>& line : lens_.programmed) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        const LensPoint way = line[i] - line[i - 1];
        const double length = way.norm();
        if (length > 0) {
          const LensPoint beside = side / length * LensPoint(-way.y(), way.x());
          painter.drawLine(view.at(line[i - 1] + beside), view.at(line[i] + beside));
        }
      }
    }
  }
}

void LensPicture::draw_paths(QPainter& painter, const View& view) const {
  const auto draw = [&](const std::vector<LensPoint>& points, const QPen& pen) {
    if (points.empty()) {
      return;
    }
    QPainterPath path(view.at(points.front()));
    for (const LensPoint& point : points) {
      path.lineTo(view.at(point));
    }
    painter.strokePath(path, pen);
  };
  for (const std::vector<LensPoint>& line : lens_.programmed) {
    draw(line, QPen(view.ink(0.5), scale_));
  }
  for (std::size_t i = 0; i < lens_.runs.size(); ++i) {
    QPen pen(looks_[i].colour, 2 * scale_);
    pen.setCapStyle(Qt::FlatCap);
    if (!looks_[i].dashes.isEmpty()) {
      pen.setDashPattern(looks_[i].dashes);
    }
    draw(lens_.runs[i].path, pen);
  }
  painter.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < lens_.runs.size(); ++i) {
    painter.setBrush(looks_[i].colour);
    painter.drawEllipse(view.at(lens_.runs[i].cursor), 3.5 * scale_, 3.5 * scale_);
  }
}

void LensPicture::draw_scales(QPainter& painter, const View& view) const {
  const double tick = 3 * scale_;
  const double edge = margin * scale_;
  painter.setFont(font_of(painter.font(), text_pixels * scale_));
  const QFontMetricsF metrics(painter.font());
  painter.setPen(QPen(view.ink(0.7), scale_));
  const auto name = [](double length, const QString& pattern) {
    constexpr double in_um = 0.1;  // [mm]
    return pattern.arg(significant_text(length, length < in_um ? Dimension::error : Dimension::length, 3));
  };
  const double along = round_down_125(bar_share * lens_.width);
  const double y = view.plot.bottom() - edge;
  const double left = view.plot.left() + edge;
  const double right = left + along * view.along;
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  painter.drawLine(QPointF(left, y - tick), QPointF(left, y + tick));
  painter.drawLine(QPointF(right, y - tick), QPointF(right, y + tick));
  const QString along_text = name(along, tr("%1 along"));
  const QRectF along_room(left, y - 2 * tick - metrics.ascent(), metrics.horizontalAdvance(along_text),
                          metrics.height());
  view.make_pale(painter, along_room);
  painter.drawText(QPointF(left, y - 2 * tick), along_text);
  const double across = round_down_125(bar_share * lens_.height);
  const double x = view.plot.right() - edge;
  const double high = y - across * view.across;
  painter.drawLine(QPointF(x, y), QPointF(x, high));
  painter.drawLine(QPointF(x - tick, y), QPointF(x + tick, y));
  painter.drawLine(QPointF(x - tick, high), QPointF(x + tick, high));
  const QString across_text = name(across, tr("%1 across"));
  QRectF room = metrics.boundingRect(across_text);
  room.moveCenter({x - 2 * tick - room.width() / 2, (y + high) / 2});
  if (room.intersects(along_room.adjusted(0, 0, 2 * tick, 0))) {
    room.moveBottom(along_room.top());
  }
  view.make_pale(painter, room);
  painter.drawText(room, Qt::AlignCenter, across_text);
}

/// Draws name, largest error in the picture and feed at the cursor of each run, top left.
void LensPicture::draw_table(QPainter& painter, const View& view) const {
  painter.setFont(font_of(painter.font(), text_pixels * scale_));
  const QFontMetricsF metrics(painter.font());
  const double row = metrics.height() * 1.25;
  const double gap = 2 * margin * scale_;
  const double sample = 28 * scale_;
  const double left = view.plot.left() + margin * scale_;
  std::array<double, 3> widths{};
  std::vector<std::array<QString, 3>> rows{{QString(), tr("largest error"), tr("feed")}};
  for (std::size_t i = 0; i < lens_.runs.size(); ++i) {
    rows.push_back({looks_[i].name, amount_text(lens_.runs[i].largest_error, Dimension::error),
                    amount_text(lens_.runs[i].feed, Dimension::feed)});
  }
  for (const auto& cells : rows) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      widths[c] = std::max(widths[c], metrics.horizontalAdvance(cells[c]));
    }
  }
  double y = view.plot.top() + margin * scale_;
  view.make_pale(painter, QRectF(left, y, sample + 2.5 * gap + widths[0] + widths[1] + widths[2],
                                 row * static_cast<double>(rows.size())));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    double x = left;
    if (r > 0) {
      QPen pen(looks_[r - 1].colour, 2 * scale_);
      pen.setCapStyle(Qt::FlatCap);
      if (!looks_[r - 1].dashes.isEmpty()) {
        pen.setDashPattern(looks_[r - 1].dashes);
      }
      painter.setPen(pen);
      painter.drawLine(QPointF(x, y + row / 2), QPointF(x + sample, y + row / 2));
    }
    x += sample + gap / 2;
    painter.setPen(view.ink(r == 0 ? 0.6 : 1));
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      painter.drawText(QRectF(x, y, widths[c], row),
                       (c == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, rows[r][c]);
      x += widths[c] + gap;
    }
    y += row;
  }
}

}  // namespace feedscope::ui
