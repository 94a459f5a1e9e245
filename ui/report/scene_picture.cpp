#include "ui/report/scene_picture.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QPaintEngine>
#include <QPainter>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "ui/report/scene_vectors.h"
#include "ui/scene/picture.h"
#include "ui/scene/render_window.h"
#include "ui/workbench/run_comparison.h"

namespace feedscope::ui {

namespace {

Rgb rgb_of(const QColor& colour) {
  return {colour.redF(), colour.greenF(), colour.blueF()};
}

std::vector<OverlayRun> overlays_of(const ReportInput& input, std::size_t row) {
  std::vector<OverlayRun> overlays;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    if (i != row) {
      const ReportRun& run = input.runs[i];
      const double apart =
          run.shown->run.summary.max_contour_error + input.runs[row].shown->run.summary.max_contour_error;
      overlays.push_back(
          {run.shown->samples, rgb_of(run.colour), lettered_title(input, i).toStdString(), apart});
    }
  }
  for (const ReportTrace& trace : input.traces) {
    if (row == input.current) {
      overlays.push_back({trace.shown->samples, rgb_of(trace.colour), trace.name.toStdString()});
    }
  }
  return overlays;
}

using PictureWindow = vtkSmartPointer<vtkGenericOpenGLRenderWindow>;

/// Windows of this thread between two pictures.
struct SpareWindow {
  PictureWindow window;  ///< null: none, or in use
  int users = 0;         ///< SharedPictureWindow
};

SpareWindow& spare() {
  thread_local SpareWindow windows;
  return windows;
}

PictureWindow take_window(bool transparent) {
  PictureWindow window = transparent ? nullptr : std::exchange(spare().window, nullptr);
  if (window == nullptr) {
    window = make_render_window(RenderBackend::software);
    window->SetAlphaBitPlanes(transparent ? 1 : 0);
  }
  return window;
}

QSize pixels_of(const QSizeF& size, double ratio) {
  const QSize pixels(static_cast<int>(std::lround(size.width() * ratio)),
                     static_cast<int>(std::lround(size.height() * ratio)));
  for (const int side : {pixels.width(), pixels.height()}) {
    if (side < 1 || side > largest_picture_side) {
      throw InputError(message(NC_("core",
                                   "the 3D view would have {} x {} pixels, and each side may have 1 to {}; "
                                   "use a smaller --size, --scale or --dpi"),
                               pixels.width(), pixels.height(), largest_picture_side));
    }
  }
  return pixels;
}

}  // namespace

SharedPictureWindow::SharedPictureWindow() {
  ++spare().users;
}

SharedPictureWindow::~SharedPictureWindow() {
  if (--spare().users == 0) {
    spare().window = nullptr;
  }
}

ScenePicture::ScenePicture(const ReportInput& input, std::size_t row, ThemeKind theme, bool transparent)
    : input_(input), row_(row), window_(take_window(transparent)), theme_(theme), transparent_(transparent) {
  const ReportRun& run = input.runs[row];
  scene_.set_background(theme == ThemeKind::dark ? Background::dark : Background::light);
  scene_.set_transparent(transparent);
  scene_.set_texts(input.texts);
  scene_.set_programmed(run.shown->run.path.toolpath);
  scene_.set_executed(run.shown->run.trajectory, samples());
  scene_.set_overlays(overlays_of(input, row));
  scene_.set_run_colour(rgb_of(run.colour));
  scene_.attach(*window_);
  set_scene_state(scene_, input.scene);
  show_stretch();
  if (input.view) {
    scene_.set_standard_view(*input.view);
  }
}

/// As in the window, but without the tool.
void ScenePicture::show_stretch() {
  const StretchChoice& stretch = input_.scene.stretch;
  if (stretch.stretch == PathStretch::charts && input_.charts.time) {
    scene_.set_highlight(std::array{input_.charts.time->lower, input_.charts.time->upper});
  } else if (stretch.stretch == PathStretch::to_cursor && input_.cursor) {
    scene_.set_tool({ToolKind::none, scene_.tool().diameter, scene_.tool().corner_radius});
    const Trajectory& trajectory = *input_.runs[row_].shown->run.trajectory;
    scene_.set_cursor(trajectory.state(std::min(*input_.cursor, trajectory.duration())));
  }
}

/// Samples of the run, compared with another one if the colours need that.
std::shared_ptr<const SampledPath> ScenePicture::samples() {
  const ShownRun& shown = *input_.runs[row_].shown;
  const auto reference = needs_reference(input_.scene.colouring)
                             ? reference_row(input_.runs.size(), row_, input_.reference, std::nullopt)
                             : std::nullopt;
  if (!reference || shown.run.trajectory->pieces().empty()) {
    return shown.samples;
  }
  const ReportRun& other = input_.runs[*reference];
  scene_.set_comparison(other.name.toStdString(), nullptr);
  return std::make_shared<const SampledPath>(
      sample_compared(shown.run.trajectory, *other.shown->run.trajectory, other.shown->samples->times,
                      nullptr, shown.run.sources));
}

ScenePicture::~ScenePicture() {
  scene_.detach();
  if (spare().users > 0 && !transparent_) {
    window_->SetSize(0, 0);  // as a new one
    spare().window = std::move(window_);
  }
}

void ScenePicture::prepare(const QSizeF& size, const SceneScale& scale) {
  const QSize pixels = pixels_of(size, scale.pixel_ratio);
  scene_.set_scale(scale.text_scale * scale.pixel_ratio);
  window_->SetSize(pixels.width(), pixels.height());
}

QImage ScenePicture::image(const QSizeF& size, const SceneScale& scale) {
  prepare(size, scale);
  const QSize pixels = pixels_of(size, scale.pixel_ratio);
  window_->Render();
  QImage image(pixels, transparent_ ? QImage::Format_RGBA8888_Premultiplied : QImage::Format_RGBX8888);
  read_frame(*window_, [&image](int y) { return image.scanLine(y); });
  return image;
}

AnnotatedView ScenePicture::annotated(const QSizeF& size, const SceneScale& scale) const {
  const ReportRun& run = input_.runs[row_];
  return {scene_,
          *run.shown->run.trajectory,
          size * scale.pixel_ratio,
          scale.text_scale * scale.pixel_ratio,
          theme_ == ThemeKind::dark ? Background::dark : Background::light,
          run.name,
          run.shown->run.sources};
}

/// Paints vectors; false if the frame cannot be drawn as vectors.
bool ScenePicture::paint_lines(QPainter& painter, const QRectF& place, const SceneScale& scale) {
  prepare(place.size(), scale);
  scene_.lay_out();
  painter.save();
  if (!transparent_) {
    const Rgb& colour =
        scene_colours(theme_ == ThemeKind::dark ? Background::dark : Background::light).background;
    painter.fillRect(place, QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                                             static_cast<float>(colour[2])));
  }
  painter.translate(place.topLeft());
  painter.scale(1 / scale.pixel_ratio, 1 / scale.pixel_ratio);
  const bool drawn = paint_vectors(painter, *window_, scale.text_scale * scale.pixel_ratio);
  painter.restore();
  return drawn;
}

void ScenePicture::paint(QPainter& painter, const QRectF& asked, const SceneScale& scale) {
  const auto snapped = [&](double value) {
    return std::round(value * scale.pixel_ratio) / scale.pixel_ratio;
  };
  const QPointF corner(snapped(asked.left()), snapped(asked.top()));
  const QRectF place(corner, QPointF(snapped(asked.right()), snapped(asked.bottom())));  // whole pixels
  if (painter.paintEngine()->type() == QPaintEngine::Raster || !paint_lines(painter, place, scale)) {
    painter.drawImage(place, image(place.size(), scale));
  }
  if (input_.annotations.empty()) {
    return;
  }
  const AnnotatedView view = annotated(place.size(), scale);
  painter.save();
  painter.setClipRect(place, Qt::IntersectClip);
  painter.translate(place.topLeft());
  painter.scale(1 / scale.pixel_ratio, 1 / scale.pixel_ratio);
  draw_annotations(painter, place_annotations(input_.annotations, view), view);
  painter.restore();
}

std::vector<PlacedAnnotation> ScenePicture::annotations(const QSizeF& size, const SceneScale& scale) const {
  return place_annotations(input_.annotations, annotated(size, scale));
}

QStringList ScenePicture::annotation_texts() {
  constexpr QSizeF any_size(800, 600);
  prepare(any_size, {});
  return ui::annotation_texts(input_.annotations, annotated(any_size, {}));
}

}  // namespace feedscope::ui
