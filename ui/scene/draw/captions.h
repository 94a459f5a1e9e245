#pragma once

#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/draw/canvas.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

/// What the legend may name: what is in the picture.
struct LegendEntries {
  struct Overlay {
    std::string name;
    Rgb colour{};
  };
  bool programmed = false;
  bool rapid = false;
  bool executed = false;
  bool blend = false;
  bool curve = false;      ///< smooth curves
  bool tool_axis = false;  ///< of a tool that rotary axes turn
  std::vector<Overlay> overlays;
};

/// What is written over the picture of a path.
struct Captions {
  LegendEntries entries;
  ColourKey key;
  Rgb run{};                ///< colour of the run, for Colouring::run
  double exaggeration = 1;  ///< of deviations
  const SceneColours* colours = nullptr;
  const SceneTexts* texts = nullptr;
  bool on_machine = false;   ///< the path is drawn in the coordinates of the machine
  bool transparent = false;  ///< nothing is put behind the texts
  bool legend = true;        ///< false: another view beside this one explains both
  bool cube = false;
};

/// Where what is written over the picture has its place; empty where there is nothing.
struct ScreenLayout {
  double width, height;       ///< [pixels]
  double scale;               ///< of text and lines
  ScreenRectangle legend;     ///< of lines, at the top on the left
  ScreenRectangle colours;    ///< what they mean, at the bottom on the left
  ScreenRectangle scale_bar;  ///< at the bottom
  ScreenRectangle cube;       ///< at the top on the right

  ScreenRectangle window() const { return {Vec2::Zero(), {width, height}}; }
  /// The window but for a narrow margin.
  ScreenRectangle room() const;
  /// Those that are not empty.
  std::vector<ScreenRectangle> covered() const;
  /// A square in a lower corner, above what is there.
  ScreenRectangle inset(double side, bool left) const;
};

ScreenLayout screen_layout(int width, int height, double scale, const Captions& captions);

/// What the colours mean, with the other run that they compare with: "Time lost or gained against B".
std::string colour_title(const ColourKey& key, const SceneTexts& texts);

/// Of how many causes the names have room at the bottom of a window; the longest are named first.
std::size_t named_causes(int width, int height, double scale, const Captions& captions);

/// Draws legend, colours and a bar of round length (in a perspective view true in the middle of the view
/// only, and omitted). `millimetre`: pixels a mm.
void draw_captions(Canvas& canvas, const ScreenLayout& layout, const Captions& captions,
                   const Projection& projection, double millimetre);

}  // namespace feedscope::ui
