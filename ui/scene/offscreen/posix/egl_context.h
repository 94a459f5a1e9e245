#pragma once

#include <memory>

#include "ui/scene/offscreen/offscreen_context.h"

namespace feedscope::ui {

/// EGL without a surface: on Mesa's software device, so that pictures are equal on every machine, else on
/// Mesa's default. It has no default frame buffer. Throws InputError if libEGL is missing or
/// offers no OpenGL 3.2 core context without a surface.
std::unique_ptr<OffscreenContext> make_egl_context();

}  // namespace feedscope::ui
