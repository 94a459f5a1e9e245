#pragma once

#include <memory>

namespace feedscope::ui {

/// An OpenGL 3.2 core context without a display, for one thread at a time. While it is current, the OpenGL
/// library and GLEW reach it.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;

  /// Makes it current for this thread. Its default frame buffer, if any, has one pixel: draw into others.
  virtual void make_current() = 0;
  virtual void release() = 0;
  virtual bool is_current() const = 0;
};

/// posix/: OSMesa, or EGL without a surface where Mesa no longer contains OSMesa; FEEDSCOPE_OFFSCREEN=osmesa
/// or egl in the environment selects one of them. windows/: the graphics driver's, of a hidden window. Throws
/// InputError with the reasons if none works.
std::unique_ptr<OffscreenContext> make_offscreen_context();

}  // namespace feedscope::ui
