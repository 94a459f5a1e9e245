#include "ui/report/pictures.h"

#include <QApplication>
#include <QPainter>
#include <algorithm>

#include "core/analysis/lens.h"
#include "core/base/error.h"
#include "ui/report/charts_page.h"
#include "ui/report/scene_picture.h"
#include "ui/report/sheet.h"
#include "ui/scene/picture.h"
#include "ui/shared/lens_picture.h"
#include "ui/theme/theme.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

PictureSpec spec_of(const PictureRequest& request, const QString& title) {
  return {request.format, request.size,        request.pixel_ratio,
          request.paper,  request.transparent, QApplication::palette().color(QPalette::Window),
          title};
}

}  // namespace

std::string scene_file(const ReportInput& input, const PictureRequest& request) {
  ScenePicture picture(input, input.current, request.theme, request.transparent);
  // On paper text keeps its size; a larger picture for the screen has larger text.
  const QSize whole = request.size.toSize();
  const SceneScale scale{request.pixel_ratio, request.paper ? 1 : scale_for({whole.width(), whole.height()})};
  return make_picture(spec_of(request, input.heading()), [&](QPainter& painter) {
    picture.paint(painter, QRectF(QPointF(), request.size), scale);
  });
}

std::string charts_file(const ReportInput& input, const PictureRequest& request) {
  ChartsPage page;
  page.set_runs(input, input.current);
  const QSize least = page.minimumSizeHint();
  const QSize size = request.size.toSize();
  if (size.width() < least.width() || size.height() < least.height()) {
    throw InputError(QStringLiteral("charts of %1 x %2 units are too small; they need at least %3 x %4: use "
                                    "a larger --size or a smaller --scale")
                         .arg(size.width())
                         .arg(size.height())
                         .arg(least.width())
                         .arg(least.height())
                         .toStdString());
  }
  constexpr double enough_for_shapes = 2;  // columns of a curve to a unit, where each is a shape of its own
  page.prepare(size, request.format == PictureFormat::png ? request.pixel_ratio
                                                          : std::min(request.pixel_ratio, enough_for_shapes));
  const bool as_on_screen =
      request.format == PictureFormat::png && !request.paper && request.pixel_ratio == 1;
  if (as_on_screen && !request.transparent) {
    return image_file(page.grab().toImage(), request, {});
  }
  return make_picture(spec_of(request, input.heading()),
                      [&](QPainter& painter) { page.draw(painter, !request.transparent); });
}

std::string lens_file(const ReportInput& input, double time, const PictureRequest& request) {
  std::vector<const Run*> runs;
  std::vector<LensLook> looks;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    const ReportRun& run = input.runs[i];
    if (run.shown->run.trajectory->path().empty()) {
      continue;  // the control runs nothing of it
    }
    shown = i == input.current ? runs.size() : shown;
    runs.push_back(&run.shown->run);
    looks.push_back({run.name, run.colour, run_dashes(i)});
  }
  const Lens lens = lens_at(runs, shown, time);
  const QSize whole = request.size.toSize();
  const double scale = request.paper ? 1 : scale_for({whole.width(), whole.height()});
  return make_picture(spec_of(request, input.heading()), [&](QPainter& painter) {
    painter.setFont(QApplication::font());
    LensPicture(lens, looks, scale).paint(painter, QRectF(QPointF(), request.size), QApplication::palette());
  });
}

std::string sheet_file(const ReportInput& input, const PictureRequest& request) {
  return make_picture(spec_of(request, input.heading()), [&](QPainter& painter) {
    paint_sheet(painter, request.size, input, {request.pixel_ratio, request.theme, request.transparent});
  });
}

std::string image_file(const QImage& image, const PictureRequest& request, const QString& title) {
  return make_picture(spec_of(request, title),
                      [&](QPainter& painter) { painter.drawImage(QRectF(QPointF(), request.size), image); });
}

}  // namespace feedscope::ui
