#include "ui/scene/offscreen/offscreen_context.h"

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "ui/scene/offscreen/posix/egl_context.h"
#include "ui/scene/offscreen/posix/osmesa_context.h"

namespace feedscope::ui {
namespace {

struct Kind {
  std::string_view name;
  std::unique_ptr<OffscreenContext> (*make)();
};

constexpr std::array kinds{Kind{"osmesa", make_osmesa_context}, Kind{"egl", make_egl_context}};

}  // namespace

std::unique_ptr<OffscreenContext> make_offscreen_context() {
  const char* given = std::getenv("FEEDSCOPE_OFFSCREEN");
  const std::string_view wanted = given != nullptr ? given : "";
  std::string reasons;
  for (const Kind& kind : kinds) {
    if (!wanted.empty() && wanted != kind.name) {
      continue;
    }
    try {
      return kind.make();
    } catch (const InputError& error) {
      reasons += (reasons.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  throw InputError(reasons.empty()
                       ? "FEEDSCOPE_OFFSCREEN is '" + std::string(wanted) + "'; it must be osmesa or egl"
                       : "no OpenGL without a display: " + reasons + "; install libosmesa6 or libegl-mesa0");
}

}  // namespace feedscope::ui
