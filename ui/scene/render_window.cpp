#include "ui/scene/render_window.h"

#include <optional>
#include <stdexcept>

#include "ui/scene/gl_render_window.h"
#include "ui/scene/osmesa_render_window.h"

namespace feedscope::ui {

vtkSmartPointer<vtkGenericOpenGLRenderWindow> make_render_window(RenderBackend backend) {
  static std::optional<RenderBackend> used;
  if (used && *used != backend) {
    throw std::logic_error("3D view: this process already draws with the other backend; use one kind only");
  }
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
  if (backend == RenderBackend::software) {
    window = vtkSmartPointer<OsmesaRenderWindow>::New();
  } else {
    window = vtkSmartPointer<GlRenderWindow>::New();
    window->SetReadyForRendering(false);
  }
  used = backend;
  window->SetForceMaximumHardwareLineWidth(1);  // a core profile has no wide lines: VTK's shader draws them
  window->SetMultiSamples(backend == RenderBackend::software ? 4 : 8);
  return window;
}

}  // namespace feedscope::ui
