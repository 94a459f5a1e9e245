#pragma once

#include <memory>
#include <utility>

#include "ui/scene/gl_render_window.h"
#include "ui/scene/offscreen/offscreen_context.h"

namespace feedscope::ui {

/// VTK window that needs no display, in a process whose VTK was built for GLX. VTK 9.4 has
/// vtkOSOpenGLRenderWindow in every build, which takes this class's place. New() throws std::runtime_error as
/// make_offscreen_context().
class OffscreenRenderWindow : public GlRenderWindow {
 public:
  static OffscreenRenderWindow* New();
  /// Before anything else, once.
  void use(std::unique_ptr<OffscreenContext> context) { context_ = std::move(context); }

  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  /// Of the frame buffers that are drawn into; EGL has no other that VTK could ask.
  int GetColorBufferSizes(int* rgba) override;

 protected:
  OffscreenRenderWindow();
  ~OffscreenRenderWindow() override;

 private:
  std::unique_ptr<OffscreenContext> context_;
};

}  // namespace feedscope::ui
