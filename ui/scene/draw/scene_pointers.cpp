#include "ui/scene/draw/scene_pointers.h"

namespace feedscope::ui {

void draw_scene_pointers(Canvas& canvas, const ScenePointers& pointers, const PlaceInWindow& place_of,
                         int height, const ScreenRectangle& room, double scale, const SceneColours& colours) {
  if (pointers.dimension) {
    const SceneDimension& dimension = *pointers.dimension;
    draw_dimension(canvas, place_of(dimension.from),
                   dimension.to ? std::optional(place_of(*dimension.to)) : std::nullopt, dimension.lines,
                   room, scale, colours);
  }
  if (pointers.hover) {
    draw_ring(canvas, place_of(*pointers.hover), scale, colours);
  }
  if (pointers.rubber_band) {
    const auto& [corner, opposite] = *pointers.rubber_band;
    draw_rubber_band(canvas, {corner[0], height - corner[1]}, {opposite[0], height - opposite[1]}, scale,
                     colours);
  }
}

}  // namespace feedscope::ui
