#pragma once

#include <memory>

#include "ui/scene/gl_render_window.h"

namespace feedscope::ui {

/// VTK window on a software (OSMesa) context, in a process whose VTK was built for GLX.
///
/// VTK calls OpenGL through libOpenGL and GLEW, and both go through libglvnd's dispatcher; OSMesa is
/// registered there as a vendor and made current for this thread while the window draws. Nothing is
/// preloaded, and a process that never makes such a window is untouched. VTK 9.4 has vtkOSOpenGLRenderWindow
/// in every build, which takes this class's place. New() throws std::runtime_error if OSMesa gives no
/// OpenGL 3.2 core context or the dispatcher is another version.
class OsmesaRenderWindow : public GlRenderWindow {
 public:
  static OsmesaRenderWindow* New();

  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }

 protected:
  OsmesaRenderWindow();
  ~OsmesaRenderWindow() override;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace feedscope::ui
