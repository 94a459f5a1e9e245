#pragma once

#include <memory>

#include "ui/scene/offscreen/offscreen_context.h"

namespace feedscope::ui {

/// Mesa's software renderer of libOSMesa (until Mesa 25.0). It is registered as a vendor of libglvnd's
/// dispatcher, so that nothing is preloaded and a process that never makes one is untouched. Throws
/// InputError where libOSMesa is missing, offers no OpenGL 3.2 core context, or the dispatcher is
/// another version.
std::unique_ptr<OffscreenContext> make_osmesa_context();

}  // namespace feedscope::ui
