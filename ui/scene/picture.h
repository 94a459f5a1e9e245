#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "ui/scene/path_scene.h"

namespace feedscope::ui {

struct PictureSize {
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
};

/// Bounds of a picture: software OpenGL draws it within a gigabyte.
inline constexpr int min_picture_side = 64;
inline constexpr int largest_picture_side = 8192;

/// RGB, rows from the top.
struct Picture {
  PictureSize size;
  std::vector<unsigned char> rgb;
};

/// Suitable size of text and lines in a picture: 1 at 800 x 600, larger with the picture.
double scale_for(PictureSize size);

/// The scene drawn in software; no display needed.
/// Throws InputError if a side is out of bounds, and as make_render_window().
Picture draw_picture(PathScene& scene, PictureSize size);

/// Programmed and executed path of a run, seen from `view`.
Picture draw_run(const Run& run, PictureSize size, StandardView view);

/// The bytes of a PNG file.
std::string to_png(const Picture& picture);

/// Reads a PNG file. Throws InputError naming it if it cannot be read.
Picture read_png(const std::string& file);

}  // namespace feedscope::ui
