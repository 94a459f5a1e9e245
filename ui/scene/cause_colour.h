#pragma once

#include "core/limits/cause.h"
#include "ui/scene/colour_map.h"

namespace feedscope::ui {

/// Colour of a limiting cause, the same in the scene and in every chart; the axis does not change it.
///
/// Any two are 15 or more apart in CIELAB, with normal colour vision and without red, green or blue cones
/// (Machado 2009, severity 1). Grey is the feed that was asked for; what stops the tool is dark. On a dark
/// background all are as light as lines there must be, in hues as near as that allows.
Rgb cause_colour(CauseKind kind, Background background = Background::light);

}  // namespace feedscope::ui
