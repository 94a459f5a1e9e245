#pragma once

#include <memory>

namespace feedscope::ui {

/// An OpenGL 3.2 core context that needs no display; of one thread at a time. Once it is current, libOpenGL
/// and GLEW call it through libglvnd's dispatcher.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;

  /// Makes it current for this thread, with a default frame buffer of at least `width` x `height` pixels,
  /// where it has one.
  virtual void make_current(int width, int height) = 0;
  virtual void release() = 0;
  virtual bool is_current() const = 0;
};

/// OSMesa, or EGL without a surface where Mesa has no OSMesa any more. FEEDSCOPE_OFFSCREEN=osmesa or egl in
/// the environment asks for one of them. Throws InputError saying why neither works.
std::unique_ptr<OffscreenContext> make_offscreen_context();

}  // namespace feedscope::ui
