#include "ui/scene/draw/tool_axes.h"

#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace feedscope::ui {

void draw_tool_axis(Canvas& canvas, const Vec2& from, const Vec2& to, double scale,
                    const SceneColours& colours) {
  constexpr double width = 1.1;
  constexpr double end_radius = 1.7;
  canvas.line(from, to, width * scale, colours.text);
  canvas.disc(to, end_radius * scale, colours.text);
}

void draw_tool_axes(Canvas& canvas, const SampledPath& path, const PlaceInWindow& place_of,
                    const MarkStyle& style) {
  constexpr double stroke = 36;  // [pixels]
  constexpr double square = stroke / 2;
  constexpr double far_off = 1e6;  // [pixels]
  const auto cell = [&](double pixel) {
    return static_cast<std::uint64_t>(
        static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(pixel / (square * style.scale)))));
  };
  std::unordered_set<std::uint64_t> taken;
  Vec2 last = Vec2::Constant(-far_off);
  for (const ToolAxis& axis : path.tool_axes) {
    const Vec3 tip = path.origin + axis.tip.cast<double>();
    const Vec2 from = place_of(tip);
    if (from.cwiseAbs().maxCoeff() > far_off || !taken.insert(cell(from.x()) << 32 | cell(from.y())).second) {
      continue;
    }
    if ((from - last).norm() < 0.7 * square * style.scale) {
      continue;  // next to it across the border of a square
    }
    last = from;
    const double length = stroke * style.scale / style.pixels_per_mm;
    const Vec2 to = place_of(tip + length * axis.direction.cast<double>());
    draw_tool_axis(canvas, from, to, style.scale, style.colours);
  }
}

}  // namespace feedscope::ui
