#pragma once

#include <vtkNew.h>
#include <vtkWeakPointer.h>

#include <array>

#include "ui/scene/camera/projection.h"

class vtkRenderWindow;
class vtkRenderer;

namespace feedscope::ui {

/// Pixel of the window, device pixels from its upper left corner.
using Pixel = std::array<double, 2>;

/// Three layers of one window with one camera: at the back, the frame's grid and labels and the highlights
/// under the path; then the path; in front the tool, and on top legend, panel and pointers.
class WindowLayers {
 public:
  WindowLayers();
  ~WindowLayers();

  /// Draws into `window` until detach() or the window's end.
  void attach(vtkRenderWindow& window);
  void detach();
  vtkRenderWindow* window() const;

  /// Of the window [device pixels]; 1 without one.
  int width() const;
  int height() const;
  /// Display coordinates, upwards.
  Vec2 display(const Pixel& pixel) const { return {pixel[0], height() - pixel[1]}; }

  vtkRenderer& behind() const { return *behind_; }
  vtkRenderer& middle() const { return *middle_; }
  vtkRenderer& front() const { return *front_; }

 private:
  std::array<vtkRenderer*, 3> all() const { return {behind_, middle_, front_}; }

  vtkNew<vtkRenderer> behind_;
  vtkNew<vtkRenderer> middle_;
  vtkNew<vtkRenderer> front_;
  vtkWeakPointer<vtkRenderWindow> window_;
};

}  // namespace feedscope::ui
