#include "ui/scene/window_layers.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace feedscope::ui {

WindowLayers::WindowLayers() {
  int layer = 0;
  for (vtkRenderer* renderer : all()) {
    renderer->SetLayer(layer++);
    renderer->InteractiveOff();
  }
  front_->SetActiveCamera(middle_->GetActiveCamera());
  behind_->SetActiveCamera(middle_->GetActiveCamera());
}

WindowLayers::~WindowLayers() = default;

void WindowLayers::attach(vtkRenderWindow& window) {
  window_ = &window;
  window.SetNumberOfLayers(static_cast<int>(all().size()));
  for (vtkRenderer* renderer : all()) {
    window.AddRenderer(renderer);
  }
}

void WindowLayers::detach() {
  for (vtkRenderer* renderer : all()) {
    if (window_ != nullptr) {
      window_->RemoveRenderer(renderer);
    }
  }
  window_ = nullptr;
}

vtkRenderWindow* WindowLayers::window() const {
  return window_;
}

int WindowLayers::width() const {
  return window_ != nullptr ? std::max(1, window_->GetSize()[0]) : 1;
}

int WindowLayers::height() const {
  return window_ != nullptr ? std::max(1, window_->GetSize()[1]) : 1;
}

}  // namespace feedscope::ui
