#include "ui/scene/draw/pointers.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope::ui {
namespace {

constexpr double value_text_pixels = 13;
constexpr double value_line_height = 18;

void draw_text_box(Canvas& canvas, const Vec2& beside, const std::vector<std::string>& lines,
                   const ScreenRectangle& room, double k, const SceneColours& colours) {
  if (lines.empty()) {
    return;
  }
  TextStyle style{.size = value_text_pixels * k, .colour = colours.text, .horizontal = -1};
  Vec2 size(0, (static_cast<double>(lines.size()) * value_line_height + 8) * k);
  for (const std::string& line : lines) {
    size.x() = std::max(size.x(), Canvas::text_size(line, style).x() + 16 * k);
  }
  const Vec2 wish = beside + Vec2(14, 14) * k;
  const Vec2 low = wish.cwiseMin(room.high - size).cwiseMax(room.low);
  const Vec2 high = low + size;
  const Vec2 border = Vec2::Constant(k);
  canvas.rectangle(low - border, high + border, colours.frame);
  canvas.rectangle(low, high, colours.background);
  double y = high.y() - (4 + value_line_height / 2) * k;
  for (const std::string& line : lines) {
    canvas.text(line, {low.x() + 8 * k, y}, style);
    style.bold = false;
    y -= value_line_height * k;
  }
}

}  // namespace

void draw_ring(Canvas& canvas, const Vec2& place, double scale, const SceneColours& colours) {
  constexpr int parts = 24;
  const double radius = 7 * scale;
  const auto at = [&](int i) {
    const double angle = 2 * units::pi * i / parts;
    return Vec2(place + radius * Vec2(std::cos(angle), std::sin(angle)));
  };
  for (int i = 0; i < parts; ++i) {
    canvas.line(at(i), at(i + 1), 2 * scale, colours.highlight);
  }
}

void draw_dimension(Canvas& canvas, const Vec2& from, const std::optional<Vec2>& to,
                    const std::vector<std::string>& lines, const ScreenRectangle& room, double scale,
                    const SceneColours& colours) {
  draw_ring(canvas, from, scale, colours);
  if (to) {
    draw_ring(canvas, *to, scale, colours);
    canvas.line(from, *to, 1.6 * scale, colours.highlight);
    for (const Vec2& end : {from, *to}) {
      canvas.disc(end, 3 * scale, colours.highlight);
    }
  }
  draw_text_box(canvas, to ? Vec2((from + *to) / 2) : from, lines, room, scale, colours);
}

void draw_rubber_band(Canvas& canvas, const Vec2& corner, const Vec2& opposite, double scale,
                      const SceneColours& colours) {
  const Vec2 low = corner.cwiseMin(opposite);
  const Vec2 high = corner.cwiseMax(opposite);
  canvas.rectangle(low, high, colours.highlight, 0.12);
  const std::array<Vec2, 4> corners{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    canvas.line(corners[i], corners[(i + 1) % corners.size()], 1.4 * scale, colours.highlight);
  }
}

}  // namespace feedscope::ui
