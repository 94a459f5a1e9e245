#pragma once

#include "core/limits/cause.h"
#include "ui/scene/colour_map.h"

namespace feedscope::ui {

/// Colour of a limiting cause, equal in the scene and all charts and independent of the axis.
///
/// Any two are 15 or more apart in CIELAB, with normal colour vision and without red, green or blue cones
/// (Machado 2009, severity 1). Grey is the programmed feed; stops are dark. On a dark background all are
/// light enough for lines, in the nearest possible hues.
Rgb cause_colour(CauseKind kind, Background background = Background::light);

}  // namespace feedscope::ui
