#include "ui/scene/render_window.h"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>
#include <cstring>
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

bool draws_in_software(const vtkRenderWindow* window) {
  const auto* shown = dynamic_cast<const GlRenderWindow*>(window);
  return shown != nullptr && shown->draws_in_software();
}

void set_rough_edges(vtkRenderWindow* window, bool rough) {
  if (draws_in_software(window)) {
    window->SetMultiSamples(rough ? 0 : samples_in_software);
  }
}

void read_frame(vtkRenderWindow& window, const std::function<unsigned char*(int y)>& row_at) {
  const int width = window.GetSize()[0];
  const int height = window.GetSize()[1];
  const vtkNew<vtkUnsignedCharArray> pixels;
  window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);  // as Mesa has them
  const auto row = static_cast<std::size_t>(width) * 4;
  for (int y = 0; y < height; ++y) {
    std::memcpy(row_at(height - 1 - y), pixels->GetPointer(0) + static_cast<std::size_t>(y) * row, row);
  }
}

}  // namespace feedscope::ui
