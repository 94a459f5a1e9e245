#include "ui/window/panels/program_sketch.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

/// Isometric: X to the lower right, Y to the upper right, Z up; ordinates of pictures point downwards.
QPointF seen(const Vec3& place) {
  const double across = std::numbers::sqrt3 / 2;
  return {across * (place.x() + place.y()), (place.x() - place.y()) / 2 - place.z()};
}

QRectF extent_of(const SampledPath& path) {
  QPointF low = seen(path.position(0));
  QPointF high = low;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const QPointF at = seen(path.position(i));
    low = {std::min(low.x(), at.x()), std::min(low.y(), at.y())};
    high = {std::max(high.x(), at.x()), std::max(high.y(), at.y())};
  }
  return {low, high};
}

}  // namespace

QImage program_sketch(const SampledPath& path, const QSize& size, double pixels, const QPalette& palette) {
  constexpr double margin = 8;
  constexpr int most_shade = 15;
  QImage picture(size * pixels, QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(pixels);
  const ThemeColours& colours = theme_colours(palette);
  picture.fill(colours.plot);
  if (path.size() < 2) {
    return picture;
  }
  const QRectF extent = extent_of(path);
  const double widest =
      std::max(extent.width() / (size.width() - 2 * margin), extent.height() / (size.height() - 2 * margin));
  if (!(widest > 0)) {
    return picture;
  }
  const QPointF middle(size.width() / 2.0, size.height() / 2.0);
  const auto place_of = [&](std::size_t i) {
    return middle + (seen(path.position(i)) - extent.center()) / widest;
  };
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  // Draws higher places more strongly, so that a surface of dense lines has a visible shape.
  double low = path.position(0).z();
  double high = low;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.kinds[std::min(i, path.kinds.size() - 1)] != SpanKind::rapid) {
      low = std::min(low, path.position(i).z());
      high = std::max(high, path.position(i).z());
    }
  }
  const auto shade_at = [&](double z) {
    return high > low ? static_cast<int>(std::clamp((z - low) / (high - low), 0.0, 1.0) * most_shade)
                      : most_shade;
  };
  const auto shaded = [&](int shade) {
    constexpr double palest = 0.6;
    const double part = palest + (1 - palest) * shade / most_shade;
    const auto mix = [part](int behind, int line) {
      return static_cast<int>(std::lround(std::lerp(behind, line, part)));
    };
    const QColor& line = colours.axes[2];
    return QColor(mix(colours.plot.red(), line.red()), mix(colours.plot.green(), line.green()),
                  mix(colours.plot.blue(), line.blue()));
  };
  QColor rapid = colours.muted;
  rapid.setAlpha(110);
  for (const bool rapids : {true, false}) {
    int shade = -1;
    QPolygonF line;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const SpanKind kind = path.kinds[i];
      const int next = rapids ? 0 : shade_at(path.position(i).z());
      if (next != shade) {
        painter.drawPolyline(line);
        line.clear();
        shade = next;
        painter.setPen(QPen(rapids ? rapid : shaded(shade), rapids ? 0.8 : 1.1));
      }
      if (kind != SpanKind::gap && (kind == SpanKind::rapid) == rapids) {
        line = line.isEmpty() ? QPolygonF{place_of(i)} : line;
        line.append(place_of(i + 1));
      } else if (!line.isEmpty()) {
        painter.drawPolyline(line);
        line.clear();
      }
    }
    painter.drawPolyline(line);
  }
  return picture;
}

}  // namespace feedscope::ui
