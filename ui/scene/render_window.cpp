#include "ui/scene/render_window.h"

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "ui/scene/gl_render_window.h"
#include "ui/scene/offscreen/offscreen_render_window.h"

namespace feedscope::ui {
namespace {

// Per pixel. In software each costs as much again, and Mesa has at most four.
constexpr int samples_in_software = 4;
constexpr int samples_of_gpu = 8;

}  // namespace

vtkSmartPointer<vtkGenericOpenGLRenderWindow> make_render_window(RenderBackend backend) {
  static std::optional<RenderBackend> used;
  if (used && *used != backend) {
    throw std::logic_error("3D view: this process already draws with the other backend; use one kind only");
  }
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
  if (backend == RenderBackend::software) {
    std::unique_ptr<OffscreenContext> context = make_offscreen_context();
    auto offscreen = vtkSmartPointer<OffscreenRenderWindow>::New();
    offscreen->use(std::move(context));
    window = offscreen;
  } else {
    window = vtkSmartPointer<GlRenderWindow>::New();
    window->SetReadyForRendering(false);
  }
  used = backend;
  window->SetForceMaximumHardwareLineWidth(1);  // a core profile has no wide lines: VTK's shader draws them
  window->SetMultiSamples(backend == RenderBackend::software ? samples_in_software : samples_of_gpu);
  return window;
}

void set_rough_edges(vtkRenderWindow* window, bool rough) {
  const auto* gpu = dynamic_cast<const GlRenderWindow*>(window);
  if (window != nullptr && (gpu == nullptr || gpu->draws_in_software())) {
    window->SetMultiSamples(rough ? 0 : samples_in_software);
  }
}

}  // namespace feedscope::ui
