#pragma once

#include <vtkWeakPointer.h>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace feedscope::ui {

/// While this lives, the OpenGL context of a renderer's window is the current one. Whoever takes an actor
/// away outside of a frame needs it: VTK gives the actor's buffers back there and then, in whatever context
/// is current, and without one they are lost until the window ends.
class CurrentContext {
 public:
  /// Nothing happens for a renderer without a window that draws.
  explicit CurrentContext(vtkRenderer& renderer);
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  vtkWeakPointer<vtkGenericOpenGLRenderWindow> made_current_;
};

}  // namespace feedscope::ui
