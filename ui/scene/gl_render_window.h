#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace feedscope::ui {

/// VTK's window for somebody else's OpenGL context, which also starts where there is no GLX display
/// (Wayland, EGL, OSMesa).
class GlRenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static GlRenderWindow* New();

  void OpenGLInitContext() override;
  void Start() override;

 protected:
  GlRenderWindow() = default;
};

}  // namespace feedscope::ui
