#pragma once

#include <memory>
#include <utility>

#include "ui/scene/gl_render_window.h"
#include "ui/scene/offscreen/offscreen_context.h"

namespace feedscope::ui {

/// VTK window without a display, in a process whose VTK was built for GLX. VTK 9.4 contains
/// vtkOSOpenGLRenderWindow in every build, which can replace this class. New() throws std::runtime_error as
/// make_offscreen_context().
class OffscreenRenderWindow : public GlRenderWindow {
 public:
  static OffscreenRenderWindow* New();
  /// Call once, before anything else.
  void use(std::unique_ptr<OffscreenContext> context) { context_ = std::move(context); }

  void Start() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  /// Of the frame buffers in use; VTK could not query another one with EGL.
  int GetColorBufferSizes(int* rgba) override;

 protected:
  OffscreenRenderWindow();
  ~OffscreenRenderWindow() override;

 private:
  std::unique_ptr<OffscreenContext> context_;
};

}  // namespace feedscope::ui
