#include "ui/scene/draw/path_marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "ui/scene/draw/tool_axes.h"

namespace feedscope::ui {
namespace {

constexpr double zero_radius = 9;  // wider than the mark of the start, which is often in the same place
constexpr double mark_text_pixels = 12;

/// A disc with two filled quarters, as in technical drawings.
void draw_zero_mark(Canvas& canvas, const Vec2& place, double scale, const SceneColours& colours) {
  canvas.disc(place, (zero_radius + 1) * scale, colours.text);
  canvas.disc(place, zero_radius * scale, colours.background);
  for (const double first : {0.0, units::pi}) {
    constexpr int steps = 8;
    std::vector<Vec2> quarter{place};
    for (int step = 0; step <= steps; ++step) {
      const double angle = first + step * units::pi / 2 / steps;
      quarter.push_back(place + zero_radius * scale * Vec2(std::cos(angle), std::sin(angle)));
    }
    canvas.polygon(quarter, colours.text);
  }
}

/// Names of all points in the same place as `one`; marks them as named.
std::string names_at(const std::vector<ZeroPoint>& points, std::size_t one, std::vector<bool>& is_named,
                     const SceneTexts& texts) {
  constexpr double same_place = 1e-6;  // mm
  std::string names;
  for (std::size_t i = one; i < points.size(); ++i) {
    if ((points[i].place - points[one].place).norm() < same_place) {
      is_named[i] = true;
      names += (names.empty() ? "" : ", ") + points[i].name;
      names += points[i].assumed ? " (" + texts.assumed + ")" : "";
    }
  }
  return names;
}

void draw_zero_points(Canvas& canvas, const std::vector<ZeroPoint>& points, const PlaceInWindow& place_of,
                      const MarkStyle& style) {
  if (points.size() < 2) {
    return;  // a single offset applies to the whole picture
  }
  std::vector<bool> is_named(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_named[i]) {
      const Vec2 place = place_of(points[i].place);
      draw_zero_mark(canvas, place, style.scale, style.colours);
      canvas.text(names_at(points, i, is_named, style.texts),
                  place + Vec2(zero_radius + 4, -zero_radius) * style.scale,
                  {.size = mark_text_pixels * style.scale,
                   .colour = style.colours.text,
                   .horizontal = -1,
                   .vertical = 1});
    }
  }
}

}  // namespace

void draw_start_mark(Canvas& canvas, const Vec2& place, double scale, const SceneColours& colours) {
  canvas.disc(place, 6 * scale, colours.background);
  canvas.disc(place, 5 * scale, colours.text);
  canvas.disc(place, 2.6 * scale, colours.background);
}

void draw_path_marks(Canvas& canvas, const SampledPath* programmed, const SampledPath* executed,
                     const PlaceInWindow& place_of, const MarkStyle& style) {
  if (executed != nullptr) {
    draw_tool_axes(canvas, *executed, place_of, style);
  }
  if (programmed != nullptr) {
    draw_zero_points(canvas, programmed->zero_points, place_of, style);
  }
  const SampledPath* path = executed != nullptr ? executed : programmed;
  if (path != nullptr && path->size() > 0 && !style.texts.start.empty()) {
    draw_start_mark(canvas, place_of(path->position(0)), style.scale, style.colours);
  }
}

}  // namespace feedscope::ui
