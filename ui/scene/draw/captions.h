#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// Contents of the picture that the legend may explain.
struct LegendEntries {
  struct Overlay {
    std::string name;
    Rgb colour{};
    double apart = HUGE_VAL;  ///< bound on its distance from the run [mm]
    bool beneath = false;     ///< hidden by the run in this view
  };
  bool programmed = false;
  bool rapid = false;
  bool executed = false;
  bool blend = false;
  bool curve = false;      ///< smooth curves
  bool tool_axis = false;  ///< of a tool turned by rotary axes
  bool start = false;
  std::vector<Overlay> overlays;
};

/// Texts over the picture of a path.
struct Captions {
  LegendEntries entries;
  ColourKey key;
  Rgb run{};                ///< colour of the run, for Colouring::run
  double exaggeration = 1;  ///< of deviations
  const SceneColours* colours = nullptr;
  const SceneTexts* texts = nullptr;
  bool on_machine = false;   ///< whether the path is drawn in the coordinates of the machine
  bool transparent = false;  ///< without a background of the texts
  bool legend = true;        ///< false: another view explains both
  bool cube = false;
  bool strip = false;  ///< in strips above and below the path instead of on top of it
};

/// Places of the texts over the picture; empty for missing ones.
struct ScreenLayout {
  double width, height;       ///< [pixels]
  double scale;               ///< of text and lines
  ScreenRectangle legend;     ///< of lines, at the top left
  ScreenRectangle colours;    ///< meaning of the colours, at the bottom left
  ScreenRectangle scale_bar;  ///< at the bottom
  ScreenRectangle cube;       ///< at the top right

  ScreenRectangle window() const { return {Vec2::Zero(), {width, height}}; }
  /// The window without a narrow margin.
  ScreenRectangle room() const;
  /// The rectangles that are not empty.
  std::vector<ScreenRectangle> covered() const;
  /// A square in a lower corner, above what is there.
  ScreenRectangle inset(double side, bool left) const;
};

ScreenLayout screen_layout(int width, int height, double scale, const Captions& captions);

/// Title of the colours, with the other run that they compare with: "Time lost or gained against B".
std::string colour_title(const ColourKey& key, const SceneTexts& texts);

/// Number of causes whose names fit at the bottom of a window; the longest are named first.
std::size_t named_causes(int width, int height, double scale, const Captions& captions);

/// Draws legend, colours and a bar of round length (omitted in a perspective view, where it would be true at
/// the centre only). `millimetre`: pixels per mm.
void draw_captions(Canvas& canvas, const ScreenLayout& layout, const Captions& captions,
                   const Projection& projection, double millimetre);

}  // namespace feedscope::ui
