#include "ui/scene/current_context.h"

#include <vtkRenderer.h>

#include "ui/scene/gl_render_window.h"

namespace feedscope::ui {

CurrentContext::CurrentContext(vtkRenderer& renderer) {
  auto* window = dynamic_cast<GlRenderWindow*>(renderer.GetRenderWindow());
  if (window != nullptr && window->has_drawn() && window->GetReadyForRendering() && !window->IsCurrent()) {
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
