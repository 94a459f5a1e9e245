#include "ui/report/scene_vectors.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkActor2DCollection.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "ui/paper/line_pieces.h"
#include "ui/paper/text_outline.h"
#include "ui/scene/camera/projection.h"

namespace feedscope::ui {

namespace {

QColor colour_of(const double* rgb, double opacity) {
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
                          static_cast<float>(opacity));
}

/// Colours of points; null if there are none.
vtkUnsignedCharArray* colours_of(vtkPolyData& data) {
  return vtkUnsignedCharArray::SafeDownCast(data.GetPointData()->GetScalars());
}

QColor colour_at(vtkUnsignedCharArray& colours, vtkIdType point) {
  std::array<unsigned char, 4> rgba{0, 0, 0, 255};
  colours.GetTypedTuple(point, rgba.data());
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

double area_of(const QPolygonF& polygon) {
  double twice = 0;
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    const QPointF a = polygon[i] - polygon[0];
    const QPointF b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(twice) / 2;
}

/// A filled shape of one colour.
struct Shape {
  QPainterPath path;
  QColor colour;
};

/// Contents of one layer of the window, in the order of painting.
struct LayerVectors {
  std::vector<LinePieces::Polyline> lines;
  std::vector<Shape> shapes;
  std::vector<TextOutline> letters;  ///< of shapes that represent text
};

/// Reads one layer of a window.
class LayerReader {
 public:
  LayerReader(vtkRenderer& renderer, const std::array<int, 2>& size, double scale)
      : renderer_(renderer),
        room_(0, 0, size[0], size[1]),
        height_(size[1]),
        scale_(scale),
        pieces_(room_),
        view_(*renderer.GetActiveCamera(), size[0], size[1]) {}

  /// False if the layer has contents that cannot be read.
  bool read() {
    vtkActorCollection& actors = *renderer_.GetActors();
    actors.InitTraversal();
    while (vtkActor* actor = actors.GetNextActor()) {
      if (actor->GetVisibility() != 0 && !read(*actor)) {
        return false;
      }
    }
    vtkActor2DCollection& flat = *renderer_.GetActors2D();
    flat.InitTraversal();
    while (vtkActor2D* actor = flat.GetNextActor2D()) {
      if (actor->GetVisibility() == 0) {
        continue;
      }
      if (auto* text = vtkTextActor::SafeDownCast(actor)) {
        read(*text);
      } else if (auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper())) {
        read(*mapper->GetInput());
      }
    }
    return true;
  }

  LayerVectors vectors() && { return {pieces_.sorted(), std::move(shapes_), std::move(letters_)}; }

 private:
  QPointF from_display(const Vec2& place) const { return {place.x(), height_ - place.y()}; }

  /// Reads lines; points on them need no discs, because lines have round ends and joints.
  bool read(vtkActor& actor) {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
    vtkPolyData* data = mapper != nullptr ? mapper->GetInput() : nullptr;
    if (data == nullptr || data->GetNumberOfPolys() > 0 || data->GetNumberOfStrips() > 0) {
      return data == nullptr;
    }
    vtkProperty& look = *actor.GetProperty();
    const QColor uniform = colour_of(look.GetColor(), look.GetOpacity());
    vtkUnsignedCharArray* colours = mapper->GetScalarVisibility() != 0 ? colours_of(*data) : nullptr;
    const auto colour = [&](vtkIdType point) {
      return colours != nullptr ? colour_at(*colours, point) : uniform;
    };
    const auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
    for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      lines->GetCurrentCell(count, points);
      for (vtkIdType i = 0; i + 1 < count; ++i) {
        const Vec3 from = in_scene(*actor.GetMatrix(), *data, points[i]);
        const Vec3 to = in_scene(*actor.GetMatrix(), *data, points[i + 1]);
        const auto part = shown_part(*mapper, from, to);
        if (!part) {
          continue;
        }
        const auto seen = [&](double share) {
          const Vec3 place = from + share * (to - from);
          return LineEnd{from_display(view_.to_display(place)), depth_of(place),
                         colour(share < 0.5 ? points[i] : points[i + 1])};
        };
        const bool dash = count == 2 && colours == nullptr;
        if (!pieces_.add(seen((*part)[0]), seen((*part)[1]), look.GetLineWidth(), !dash)) {
          return false;
        }
      }
    }
    return true;
  }

  static Vec3 in_scene(vtkMatrix4x4& matrix, vtkPolyData& data, vtkIdType point) {
    std::array<double, 4> at{0, 0, 0, 1};
    data.GetPoint(point, at.data());
    std::array<double, 4> moved{};
    matrix.MultiplyPoint(at.data(), moved.data());
    return {moved[0], moved[1], moved[2]};
  }

  /// Distance towards the eye [pixels at scale 1].
  double depth_of(const Vec3& place) const {
    return (place - view_.focal).dot(view_.towards) * view_.scale / scale_;
  }

  /// Fractions of a line between which it is in front of the eye and on the right side of all clipping
  /// planes; none if it is nowhere.
  std::optional<std::array<double, 2>> shown_part(vtkMapper& mapper, const Vec3& from, const Vec3& to) const {
    constexpr double near = 0.999;  // of the distance of the eye
    std::array<double, 2> part{0, 1};
    const auto cut = [&part](double at_from, double at_to) {  // keeps non-negative values
      if (at_from < 0 && at_to < 0) {
        part = {1, 0};
      } else if (at_from < 0) {
        part[0] = std::max(part[0], at_from / (at_from - at_to));
      } else if (at_to < 0) {
        part[1] = std::min(part[1], at_from / (at_from - at_to));
      }
    };
    if (view_.perspective()) {
      const auto before_eye = [&](const Vec3& place) {
        return near * view_.eye_distance - (place - view_.focal).dot(view_.towards);
      };
      cut(before_eye(from), before_eye(to));
    }
    vtkPlaneCollection* planes = mapper.GetClippingPlanes();
    for (int i = 0; planes != nullptr && i < planes->GetNumberOfItems(); ++i) {
      vtkPlane& plane = *planes->GetItem(i);
      cut(plane.EvaluateFunction(from.x(), from.y(), from.z()),
          plane.EvaluateFunction(to.x(), to.y(), to.z()));
    }
    return part[0] <= part[1] ? std::optional(part) : std::nullopt;
  }

  /// Reads polygons of one colour each.
  void read(vtkPolyData& data) {
    vtkUnsignedCharArray* colours = colours_of(data);
    if (colours == nullptr) {
      return;
    }
    const auto polygons = vtk::TakeSmartPointer(data.GetPolys()->NewIterator());
    for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      polygons->GetCurrentCell(count, points);
      QPolygonF polygon;
      for (vtkIdType i = 0; i < count; ++i) {
        const double* at = data.GetPoint(points[i]);
        polygon.append(from_display({at[0], at[1]}));
      }
      if (area_of(polygon) > 0) {  // degenerate ones would be hairlines in PDF viewers
        QPainterPath path;
        path.addPolygon(polygon);
        path.closeSubpath();
        add(path, colour_at(*colours, points[0]));
      }
    }
  }

  void read(vtkTextActor& actor) {
    TextOutline outline = text_outline(actor, height_);
    if (!outline.shape.isEmpty() && room_.intersects(outline.shape.controlPointRect())) {
      vtkTextProperty& style = *actor.GetTextProperty();
      add(outline.shape, colour_of(style.GetColor(), style.GetOpacity()));
      letters_.push_back(std::move(outline));
    }
  }

  /// Clips to the window: not all SVG readers support clips, and reports paint without one.
  void add(const QPainterPath& path, const QColor& colour) {
    const QRectF extent = path.controlPointRect();
    if (room_.contains(extent)) {
      shapes_.push_back({path, colour});
    } else if (room_.intersects(extent)) {
      QPainterPath room;
      room.addRect(room_);
      shapes_.push_back({path.intersected(room), colour});
    }
  }

  vtkRenderer& renderer_;
  QRectF room_;
  int height_;
  double scale_;
  LinePieces pieces_;
  Projection view_;
  std::vector<Shape> shapes_;
  std::vector<TextOutline> letters_;
};

}  // namespace

bool paint_vectors(QPainter& painter, vtkRenderWindow& window, double scale) {
  const std::array<int, 2> size{window.GetSize()[0], window.GetSize()[1]};
  std::vector<vtkRenderer*> renderers;
  vtkRendererCollection& all = *window.GetRenderers();
  all.InitTraversal();
  while (vtkRenderer* renderer = all.GetNextItem()) {
    renderers.push_back(renderer);
  }
  std::ranges::stable_sort(renderers, {}, &vtkRenderer::GetLayer);
  std::vector<LayerVectors> layers;
  for (vtkRenderer* renderer : renderers) {
    LayerReader reader(*renderer, size, scale);
    if (!reader.read()) {
      return false;
    }
    layers.push_back(std::move(reader).vectors());
  }
  for (const LayerVectors& layer : layers) {
    painter.setBrush(Qt::NoBrush);
    paint(painter, layer.lines);
    painter.setPen(Qt::NoPen);
    for (const Shape& shape : layer.shapes) {
      painter.setBrush(shape.colour);
      painter.drawPath(shape.path);
    }
    for (const TextOutline& text : layer.letters) {
      paint_letters(painter, text);
    }
  }
  return true;
}

}  // namespace feedscope::ui
