#pragma once

#include <vtkWeakPointer.h>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace feedscope::ui {

/// Makes the OpenGL context of a renderer's window current during its lifetime. Needed to remove an actor
/// outside of a frame: VTK then releases the actor's buffers in the current context, and without one they
/// leak until the window ends.
class CurrentContext {
 public:
  /// Does nothing for a renderer without a window that draws.
  explicit CurrentContext(vtkRenderer& renderer);
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  vtkWeakPointer<vtkGenericOpenGLRenderWindow> made_current_;
};

}  // namespace feedscope::ui
