#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>

class vtkGenericOpenGLRenderWindow;
class vtkRenderWindow;

namespace feedscope::ui {

/// Drawing backend of the 3D scene. One kind in a process: GL entry points are resolved once.
enum class RenderBackend : std::uint8_t {
  gpu,       ///< the OpenGL context of a QOpenGLWidget
  software,  ///< OSMesa, or EGL without a surface: no display, X server or GPU needed
};

/// A window for VTK to draw into. A software window is ready at once; a gpu window uses the context that its
/// widget makes current. Throws std::logic_error if the process already has a window of the other kind,
/// InputError if there is no OpenGL 3.2 without a display.
vtkSmartPointer<vtkGenericOpenGLRenderWindow> make_render_window(RenderBackend backend);

/// Whether `window` (of make_render_window; or none) may have jagged edges, which is several times as fast
/// without a GPU; a GPU always smooths them. Applies from the next frame on.
void set_rough_edges(vtkRenderWindow* window, bool rough);

}  // namespace feedscope::ui
