#include "ui/scene/current_context.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

namespace feedscope::ui {

CurrentContext::CurrentContext(vtkRenderer& renderer) {
  auto* window = vtkGenericOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
  if (window != nullptr && window->GetReadyForRendering() && !window->IsCurrent()) {
    window->MakeCurrent();
    made_current_ = window;
  }
}

CurrentContext::~CurrentContext() {
  if (made_current_ != nullptr) {
    made_current_->ReleaseCurrent();
  }
}

}  // namespace feedscope::ui
