#pragma once

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/scene/camera/fit_outline.h"
#include "ui/scene/draw/axes_box.h"
#include "ui/scene/draw/axes_cube.h"
#include "ui/scene/draw/captions.h"
#include "ui/scene/draw/path_marks.h"
#include "ui/scene/draw/scene_pointers.h"
#include "ui/scene/draw/tool.h"
#include "ui/scene/path/pick.h"
#include "ui/scene/path/scene_paths.h"
#include "ui/scene/path/shown_extent.h"
#include "ui/scene/path_scene.h"
#include "ui/scene/render_callback.h"
#include "ui/scene/render_window.h"
#include "ui/scene/window_layers.h"

namespace feedscope::ui {

/// Contents of a scene, and the preparation of its frames. Included by path_scene.cpp alone.
class PathScene::Impl : public ScenePaths {
 public:
  Impl()
      : under(stage.behind()),
        over(stage.front()),
        layers(stage.middle(), stage.behind()),
        tool_drawn(stage.front()),
        camera(*stage.middle().GetActiveCamera()) {
    call_before(stage.behind(), this,
                [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->prepare(); });
    call_before(stage.front(), this, [](vtkObject*, unsigned long, void* self, void*) {
      auto& scene = *static_cast<Impl*>(self);
      const double reach = scene.tool_drawn.reach(scene.projection(), scene.frame, scene.scale);
      scene.camera.set_clipping(reach + scene.beyond, reach + scene.beyond);
    });
    camera.look(StandardView::iso);
    apply_colours();
  }

  const SceneColours& colours() const { return *look.colours; }
  Projection projection() const { return camera.projection(stage.width(), stage.height()); }
  bool in_sight(const Vec3& point) const {
    const Vec2 at = projection().to_display(frame.to_scene(point));
    return (at.array() >= 0).all() && at.x() <= stage.width() && at.y() <= stage.height();
  }
  Captions captions() const {
    LegendEntries entries = layers.entries();
    const auto path = shown_executed() != nullptr ? shown_executed() : shown_programmed();
    entries.start = path != nullptr && path->size() > 0 && in_sight(path->position(0));
    const double millimetre = projection().scale / frame.unit;
    constexpr double seen = 0.5;  // [pixels]: a line that is shifted by less is under that of the run
    for (LegendEntries::Overlay& overlay : entries.overlays) {
      overlay.beneath = overlay.apart * look.exaggeration * millimetre < seen * scale;
    }
    return {std::move(entries), layers.key(), look.run, look.exaggeration, look.colours, &texts,
            on_machine(),       transparent,  legend,   cube_shown,        strip};
  }
  ScreenLayout layout() const { return screen_layout(stage.width(), stage.height(), scale, captions()); }
  ScreenRectangle room() const { return layout().room(); }
  ScreenRectangle inset_place() const { return layout().inset(*inset, inset_left); }
  /// What is over the picture, the inset too.
  std::vector<ScreenRectangle> covered() const {
    std::vector<ScreenRectangle> all = layout().covered();
    if (inset) {
      all.push_back(inset_place());
    }
    return all;
  }
  /// Upper left and lower right corner.
  std::array<Pixel, 2> pixels_of(const ScreenRectangle& rectangle) const {
    return {Pixel{rectangle.low.x(), stage.height() - rectangle.high.y()},
            Pixel{rectangle.high.x(), stage.height() - rectangle.low.y()}};
  }
  PickablePath pickable() const {
    const DrawnPath* path = layers.executed();
    return path != nullptr ? PickablePath{&path->samples(), &path->positions(), &path->boxes(),
                                          stretch.rest_hidden ? shown_times() : std::nullopt}
                           : PickablePath{};
  }
  std::optional<TimeStretch> shown_times() const { return stretch.times(highlight, cursor_at); }
  void apply_stretch() {
    layers.trail().end_at(cursor_at, cursor);
    const auto times = shown_times();
    const bool only = times && stretch.rest_hidden && layers.executed() != nullptr;
    layers.set_stretch(
        times, only ? std::optional(bounds_between(pickable(), (*times)[0], (*times)[1])) : std::nullopt);
    layers.set_highlight(stretch.stretch == PathStretch::charts ? std::nullopt : highlight);
    changed();
  }
  AxesCube cube() const {
    constexpr double cube_half = 13;  // [pixels], so that its largest outline is 44
    const ScreenRectangle place = layout().cube;
    return {projection(), place.centre(), place.empty() ? 0 : cube_half * scale};
  }

  void changed() const {
    if (callback) {
      callback();
    }
  }

  void rebuild() {
    const std::array paths{shown_programmed(), shown_executed()};
    const bool others = std::exchange(framed, paths) != paths;
    const bool fitted = camera.fitted();
    const CameraState state = camera.state(frame);
    if (others) {
      const ShownExtent extent = shown_extent({paths[0], paths[1]});
      near = extent.fitted;
      frame = frame_around(extent.fitted);
      beyond = extent.beyond() / frame.unit;
    }
    layers.show(paths[0], paths[1], shown_overlays(colours(), texts), frame);
    apply_stretch();
    if (others) {
      camera.set_state(state, frame);
      if (fitted) {
        fit_now();
      }
    }
    changed();
  }

  void fit_now() {
    fit_path();
    if (inset) {
      choose_corner();
    }
    fitted_in = fitted_window();
  }

  /// The inset is on the left where that is worth a change.
  void choose_corner() {
    constexpr double worth = 1.02;
    const auto height_at = [this](bool left) {
      if (inset_left != left) {
        inset_left = left;
        fit_path();
      }
      return camera.state(frame).height;
    };
    const double on_right = height_at(false);
    const bool is_free = !layout().inset(*inset, true).meets(layout().legend);
    if (!is_free || worth * height_at(true) > on_right) {
      height_at(false);
    }
  }

  /// Rapids count where they are drawn: less of them is seen then, so that they still are.
  void fit_path() {
    fit_to(outline_points({shown_programmed(), shown_executed()}, near, false));
    if (layers.shows_rapids(projection(), scale)) {
      fit_to(outline_points({shown_programmed(), shown_executed()}, near, true));
    }
  }

  void fit_to(std::vector<Vec3> points) {
    for (Vec3& point : points) {
      point = frame.to_scene(point);
    }
    if (!camera.perspective()) {  // then what is within the outline stays there, however it is fitted
      const Projection view = projection();
      std::vector<Vec2> seen(points.size());
      std::ranges::transform(points, seen.begin(), [&](const Vec3& point) {
        return Vec2(point.dot(view.right), point.dot(view.up));
      });
      seen = convex_hull(std::move(seen));
      points.resize(seen.size());
      std::ranges::transform(seen, points.begin(), [&](const Vec2& corner) -> Vec3 {
        return corner.x() * view.right + corner.y() * view.up;
      });
    }
    // Width of lines, mark of the start; less in a small picture, none in a tiny one [pixels].
    const double margin = std::clamp(0.01 * (std::min(stage.width(), stage.height()) - 120), 0.0, 6 * scale);
    std::vector<ScreenRectangle> taken = covered();
    std::ranges::transform(taken, taken.begin(), [&](const auto& place) { return place.grown(margin); });
    camera.fit(stage.width(), stage.height(), room(), taken, [&](const Projection& view) {
      std::vector<Vec2> outline;
      if (axes) {
        outline = lay_out_axes(frame, view, scale).outline;
      }
      for (const Vec3& point : points) {
        outline.push_back(view.to_display(point));
      }
      return outline;
    });
  }

  /// Parameters of a fit except the path.
  std::vector<double> fitted_window() const {
    std::vector<double> window{double(stage.width()), double(stage.height()), scale, axes ? 1.0 : 0.0};
    for (const ScreenRectangle& rectangle : covered()) {
      window.insert(window.end(),
                    {rectangle.low.x(), rectangle.low.y(), rectangle.high.x(), rectangle.high.y()});
    }
    return window;
  }

  void apply_look() {
    layers.set_look(look);
    changed();
  }

  void apply_colours() {
    const Rgb background = transparent ? Rgb{} : colours().background;
    stage.behind().SetBackground(background[0], background[1], background[2]);
    stage.behind().SetBackgroundAlpha(transparent ? 0 : 1);
    tool_drawn.set_colour(colours().tool);
    apply_look();
  }

  /// Before each frame: follows the window's size and draws the parts that depend on the camera.
  void prepare() {
    Projection view = projection();
    const ViewMotion motion = !moving                             ? ViewMotion::none
                              : draws_in_software(stage.window()) ? ViewMotion::in_software
                                                                  : ViewMotion::on_gpu;
    layers.place(frame, view, scale, motion);  // says what the legend needs
    if (camera.fitted() && fitted_in != fitted_window()) {
      fit_now();
      view = projection();
      layers.place(frame, view, scale, motion);
    }
    const std::optional<Vec3> tip = cursor ? std::optional(frame.to_scene(*cursor)) : std::nullopt;
    tool_drawn.place(tip, tool_direction(cursor_at), view, frame, scale);
    constexpr double lifted = 40;  // pixels at most, of the path's layers
    camera.set_clipping(lifted * scale / view.scale + beyond, beyond);

    under.begin();
    if (axes) {
      draw(lay_out_axes(frame, view, scale), scale, layout().window(), colours(), texts, under);
    }
    under.end();
    over.begin();
    const auto place_of = [&](const Vec3& point) { return view.to_display(frame.to_scene(point)); };
    draw_path_marks(over, shown_programmed().get(), shown_executed().get(), place_of,
                    {scale, colours(), texts, view.scale / frame.unit});
    draw_scene_pointers(over, pointers, place_of, stage.height(), room(), scale, colours());
    draw_captions(over, layout(), captions(), view, view.scale / frame.unit);
    cube().draw(over, scale, colours());
    over.end();
  }

  WindowLayers stage;
  Canvas under;
  Canvas over;
  PathLayers layers;
  Tool tool_drawn;
  SceneCamera camera;
  std::function<void()> callback;
  std::optional<PathDeviation> deviation;  ///< of the run from the programmed path

  std::optional<Vec3> cursor;       ///< as drawn
  std::optional<double> cursor_at;  ///< its time, if it is on the path
  std::optional<TimeStretch> highlight;
  StretchChoice stretch;
  ScenePointers pointers;
  PathLook look;
  SceneTexts texts;
  SceneFrame frame = frame_around({});
  double beyond = 0;  ///< how far outside the frame's box rapids may be [scene units]
  Bounds near;        ///< what a fit looks at [mm]
  std::array<std::shared_ptr<const SampledPath>, 2> framed;  ///< what `frame` is around
  bool axes = false;
  bool legend = true;
  bool cube_shown = false;
  bool strip = false;
  std::optional<double> inset;  ///< side [pixels]
  bool inset_left = false;
  bool transparent = false;
  bool moving = false;
  double scale = 1;
  std::vector<double> fitted_in;
};

}  // namespace feedscope::ui
