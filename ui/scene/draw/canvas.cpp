#include "ui/scene/draw/canvas.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>
#include <tuple>

#include "core/base/data_folder.h"
#include "core/base/units.h"

namespace feedscope::ui {
namespace {

constexpr int dots_per_inch = 72;  // one point is one pixel

struct TypeFace {
  std::string regular;
  std::string bold;
};

/// The files of DejaVu Sans; empty if it is not installed: texts are then in VTK's own Arial.
const TypeFace& type_face() {
  static const TypeFace face = [] {
    const std::filesystem::path folder = data_folder() / FEEDSCOPE_FONTS;  // which may be absolute
    TypeFace found{(folder / "DejaVuSans.ttf").string(), (folder / "DejaVuSans-Bold.ttf").string()};
    std::error_code error;
    const bool there =
        std::filesystem::exists(found.regular, error) && std::filesystem::exists(found.bold, error);
    return there ? found : TypeFace{};
  }();
  return face;
}

void apply(const TextStyle& style, vtkTextProperty& property) {
  const std::string& file = style.bold ? type_face().bold : type_face().regular;
  if (file.empty()) {
    property.SetFontFamilyToArial();
    property.SetBold(style.bold ? 1 : 0);
  } else {
    property.SetFontFamily(VTK_FONT_FILE);
    property.SetFontFile(file.c_str());
  }
  property.SetFontSize(static_cast<int>(std::lround(style.size)));
  property.SetColor(style.colour[0], style.colour[1], style.colour[2]);
  property.SetJustification(style.horizontal < 0   ? VTK_TEXT_LEFT
                            : style.horizontal > 0 ? VTK_TEXT_RIGHT
                                                   : VTK_TEXT_CENTERED);
  property.SetVerticalJustification(style.vertical < 0   ? VTK_TEXT_BOTTOM
                                    : style.vertical > 0 ? VTK_TEXT_TOP
                                                         : VTK_TEXT_CENTERED);
  property.SetOrientation(units::to_deg(style.angle));
}

Vec2 measured(const std::string& text, const TextStyle& style) {
  const vtkNew<vtkTextProperty> property;
  TextStyle level = style;
  level.angle = 0;
  apply(level, *property);
  std::array<int, 4> box{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box.data(), dots_per_inch);
  return {box[1] - box[0] + 1, box[3] - box[2] + 1};
}

}  // namespace

Canvas::Canvas(vtkRenderer& renderer) : renderer_(renderer) {
  colours_->SetNumberOfComponents(4);
  shapes_->SetPoints(points_);
  shapes_->SetPolys(cells_);
  shapes_->GetPointData()->SetScalars(colours_);
  const vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shapes_);
  actor_->SetMapper(mapper);
  renderer_.AddActor2D(actor_);
}

Canvas::~Canvas() = default;

void Canvas::begin() {
  points_->Reset();
  cells_->Reset();
  colours_->Reset();
  texts_used_ = 0;
}

void Canvas::end() {
  points_->Modified();
  cells_->Modified();
  colours_->Modified();
  shapes_->Modified();
  for (std::size_t i = texts_used_; i < texts_.size(); ++i) {
    texts_[i]->SetVisibility(0);
  }
}

void Canvas::polygon(const std::vector<Vec2>& corners, const Rgb& colour, double opacity) {
  cells_->InsertNextCell(static_cast<int>(corners.size()));
  const auto byte = [](double part) { return static_cast<unsigned char>(std::lround(255 * part)); };
  const std::array<unsigned char, 4> rgba{byte(colour[0]), byte(colour[1]), byte(colour[2]), byte(opacity)};
  for (const Vec2& corner : corners) {
    cells_->InsertCellPoint(points_->InsertNextPoint(corner.x(), corner.y(), 0));
    colours_->InsertNextTypedTuple(rgba.data());
  }
}

void Canvas::line(const Vec2& from, const Vec2& to, double width, const Rgb& colour) {
  const Vec2 along = to - from;
  if (along.norm() < 1e-9) {
    return;
  }
  const Vec2 side = Vec2(-along.y(), along.x()).normalized() * (width / 2);
  polygon({from - side, to - side, to + side, from + side}, colour, 1);
}

void Canvas::dashes(const Vec2& from, const Vec2& to, double width, double dash, const Rgb& colour) {
  const double length = (to - from).norm();
  const Vec2 along = (to - from) / length;
  for (double s = 0; s < length; s += 2 * dash) {
    line(from + s * along, from + std::min(s + dash, length) * along, width, colour);
  }
}

void Canvas::rectangle(const Vec2& low, const Vec2& high, const Rgb& colour, double opacity) {
  polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, colour, opacity);
}

void Canvas::disc(const Vec2& centre, double radius, const Rgb& colour) {
  constexpr int corners = 32;
  std::vector<Vec2> rim;
  rim.reserve(corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * units::pi * i / corners;
    rim.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  polygon(rim, colour, 1);
}

void Canvas::text(const std::string& text, const Vec2& place, const TextStyle& style) {
  if (texts_used_ == texts_.size()) {
    texts_.push_back(vtkSmartPointer<vtkTextActor>::New());
    renderer_.AddActor2D(texts_.back());
  }
  vtkTextActor& actor = *texts_[texts_used_++];
  actor.SetVisibility(1);
  actor.SetInput(text.c_str());
  apply(style, *actor.GetTextProperty());
  actor.SetPosition(std::round(place.x()), std::round(place.y()));
}

Vec2 Canvas::text_size(const std::string& text, const TextStyle& style) {
  // Each frame needs the same few hundred, and measuring a text is slow.
  using Key = std::tuple<std::string, int, bool>;
  constexpr std::size_t max_kept = 4096;
  thread_local std::map<Key, Vec2> known;
  const Key key(text, static_cast<int>(std::lround(style.size)), style.bold);
  if (const auto found = known.find(key); found != known.end()) {
    return found->second;
  }
  if (known.size() == max_kept) {
    known.clear();
  }
  return known.emplace(key, measured(text, style)).first->second;
}

}  // namespace feedscope::ui
