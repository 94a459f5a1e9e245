#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace feedscope::ui {

/// VTK's window for an external OpenGL context, which also starts without a GLX display
/// (Wayland, EGL, OSMesa).
class GlRenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static GlRenderWindow* New();

  void OpenGLInitContext() override;
  void Start() override;
  void Frame() override;
  /// Whether it has drawn, so that VTK may have buffers in its context.
  bool has_drawn() const { return this->Initialized; }
  /// Whether the context is Mesa's without a GPU; false before the first frame.
  bool draws_in_software() const { return software_; }

 protected:
  GlRenderWindow() = default;

 private:
  bool software_ = false;
};

}  // namespace feedscope::ui
