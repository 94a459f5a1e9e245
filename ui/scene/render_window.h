#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <functional>

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

/// Whether the processor draws `window` (of make_render_window; or none); false before its first frame.
bool draws_in_software(const vtkRenderWindow* window);

/// Whether `window` may be drawn with jagged edges, several times as fast where the processor draws; a GPU
/// smooths them always. Holds from the next frame on.
void set_rough_edges(vtkRenderWindow* window, bool rough);

/// Copies the last frame of `window`, 4 bytes a pixel (red, green, blue, alpha), its upper row first.
/// `row_at`: where row `y` from above goes.
void read_frame(vtkRenderWindow& window, const std::function<unsigned char*(int y)>& row_at);

}  // namespace feedscope::ui
