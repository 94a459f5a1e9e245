#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/colour_map.h"

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
class vtkUnsignedCharArray;

namespace feedscope::ui {

struct TextStyle {
  double size = 13;  ///< [pixels]
  Rgb colour{};
  bool bold = false;
  int horizontal = 0;  ///< -1: the text begins at its place, 0: is centred on it, 1: ends there
  int vertical = 0;    ///< -1: the text is above its place, 0: centred on it, 1: below it
  double angle = 0;    ///< anticlockwise [rad]
};

/// Flat drawing in display coordinates, rebuilt for each frame between begin() and end().
class Canvas {
 public:
  explicit Canvas(vtkRenderer& renderer);
  ~Canvas();

  void begin();
  void end();
  void line(const Vec2& from, const Vec2& to, double width, const Rgb& colour);
  void dashes(const Vec2& from, const Vec2& to, double width, double dash, const Rgb& colour);
  void rectangle(const Vec2& low, const Vec2& high, const Rgb& colour, double opacity = 1);
  /// Convex, corners in order.
  void polygon(const std::vector<Vec2>& corners, const Rgb& colour, double opacity = 1);
  void disc(const Vec2& centre, double radius, const Rgb& colour);
  void text(const std::string& text, const Vec2& place, const TextStyle& style);

  /// Width and height of a horizontal text [pixels].
  static Vec2 text_size(const std::string& text, const TextStyle& style);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkPolyData> shapes_;
  vtkNew<vtkActor2D> actor_;
  std::vector<vtkSmartPointer<vtkTextActor>> texts_;  ///< reused in the next frame: creating one is slow
  std::size_t texts_used_ = 0;
};

}  // namespace feedscope::ui
