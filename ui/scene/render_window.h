#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>

class vtkGenericOpenGLRenderWindow;
class vtkRenderWindow;

namespace feedscope::ui {

/// What draws the 3D scene. One kind a process: GL entry points are resolved once.
enum class RenderBackend : std::uint8_t {
  gpu,       ///< the OpenGL context that a QOpenGLWidget makes current
  software,  ///< OSMesa, or EGL without a surface: no display, X server or GPU needed
};

/// A window for VTK to draw into. A software window is ready at once; a gpu window belongs to the context
/// that its widget makes current. Throws std::logic_error when the process has already made a window of the
/// other kind, InputError when there is no OpenGL 3.2 without a display.
vtkSmartPointer<vtkGenericOpenGLRenderWindow> make_render_window(RenderBackend backend);

/// Whether `window` (of make_render_window; or none) may be drawn with jagged edges, several times as fast
/// where no GPU draws; a GPU smooths them always. Holds from the next frame on.
void set_rough_edges(vtkRenderWindow* window, bool rough);

}  // namespace feedscope::ui
