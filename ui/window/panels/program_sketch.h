#pragma once

#include <QImage>
#include <QPalette>
#include <QSize>

#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// A programmed path as a small picture, seen from the front, the right and above: cuts as lines, rapids
/// paler. `pixels` per unit of `size`. A path without an extent gives an empty picture.
QImage program_sketch(const SampledPath& path, const QSize& size, double pixels, const QPalette& palette);

}  // namespace feedscope::ui
