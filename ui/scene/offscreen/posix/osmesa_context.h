#pragma once

#include <memory>

#include "ui/scene/offscreen/offscreen_context.h"

namespace feedscope::ui {

/// Mesa's software renderer of libOSMesa (until Mesa 25.0). Registered as a vendor of libglvnd's dispatcher,
/// so that nothing is preloaded, and a process that never creates one is unaffected. Throws InputError if
/// libOSMesa is missing, offers no OpenGL 3.2 core context, or the dispatcher has
/// another version.
std::unique_ptr<OffscreenContext> make_osmesa_context();

}  // namespace feedscope::ui
