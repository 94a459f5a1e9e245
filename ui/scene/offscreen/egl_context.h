#pragma once

#include <memory>

#include "ui/scene/offscreen/offscreen_context.h"

namespace feedscope::ui {

/// EGL without a surface: on Mesa's software device, so that pictures are the same on every machine, else on
/// what Mesa finds. It has no default frame buffer. Throws InputError where libEGL is missing or
/// offers no OpenGL 3.2 core context without a surface.
std::unique_ptr<OffscreenContext> make_egl_context();

}  // namespace feedscope::ui
