#include "ui/report/pictures.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/analysis/notes/not_counted.h"
#include "core/base/error.h"
#include "core/toolpath/machine_path.h"
#include "ui/language/in_language.h"
#include "ui/language/texts.h"
#include "ui/report/blocks/report_cards.h"
#include "ui/report/blocks/report_time.h"
#include "ui/report/charts_page.h"
#include "ui/report/scene_picture.h"
#include "ui/report/sheet.h"
#include "ui/scene/draw/captions.h"
#include "ui/scene/picture.h"
#include "ui/scene/scene_style.h"
#include "ui/theme/fonts.h"
#include "ui/theme/theme.h"
#include "ui/workbench/reading_faults.h"
#include "ui/workbench/run_comparison.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

struct PictureCaption {
  Q_DECLARE_TR_FUNCTIONS(PictureCaption)
};

QColor ink_of(const Rgb& rgb) {
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
}

const SceneColours& picture_colours(const PictureRequest& request) {
  return scene_colours(request.theme == ThemeKind::dark ? Background::dark : Background::light);
}

/// Text keeps its size on paper; in a larger picture for the screen it is larger.
double text_scale_of(const PictureRequest& request) {
  const QSize whole = request.size.toSize();
  return request.paper ? 1 : scale_for({whole.width(), whole.height()});
}

/// Meaning of the colours of the 3D view.
QString colour_meaning(const ReportInput& input) {
  ColourKey key{input.scene.colouring, {}, {}, {}};
  if (key.colouring == Colouring::run) {
    return PictureCaption::tr("run");
  }
  const auto reference = needs_reference(key.colouring)
                             ? reference_row(input.runs.size(), input.current, input.reference, std::nullopt)
                             : std::nullopt;
  key.reference = reference ? input.runs[*reference].name.toStdString() : std::string();
  return QString::fromStdString(colour_title(key, input.texts));
}

/// Paints program, its errors, machine, run, cycle time and colours in one line at the bottom of a picture,
/// with the parts not in the cycle time if there is room. `place`: of a close-up. Returns the area above it.
QRectF paint_caption(QPainter& painter, const ReportInput& input, const QString& colours,
                     const PictureRequest& request, const QString& place = {}) {
  constexpr double row = 24;  // [1/96 inch] at scale 1
  constexpr double text_size = 12;
  constexpr double margin = 10;
  const double scale = text_scale_of(request);
  const Run& run = input.run().shown->run;
  const QString separator = QStringLiteral(" · ");
  const QString name =
      input.runs.size() > 1 ? run_letter(input.current) + ' ' + input.run().name : input.run().name;
  QStringList parts{input.heading(), QString::fromStdString(run.setup.machine.name), name,
                    clock_text(run.trajectory->duration()), PictureCaption::tr("colour: %1").arg(colours)};
  if (const QString faults = reading_faults_text(*run.input.program); !faults.isEmpty()) {
    parts.insert(1, faults);
  }
  if (!place.isEmpty()) {
    parts.prepend(place);
  }
  const QString text = parts.join(separator);
  const QString omitted = in_language(not_counted_note(not_counted(*run.path)));
  const QString whole = omitted.isEmpty() ? text : text + separator + omitted;

  QFont font = QApplication::font();
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(text_size * scale))));
  painter.setFont(font);
  painter.setPen(ink_of(picture_colours(request).text));
  const QFontMetricsF metrics(font);
  const QRectF all(QPointF(), request.size);
  const QRectF above = all.adjusted(0, 0, 0, -row * scale);
  const QRectF inner =
      QRectF(above.bottomLeft(), all.bottomRight()).adjusted(margin * scale, 0, -margin * scale, 0);
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   metrics.horizontalAdvance(whole) <= inner.width()
                       ? whole
                       : metrics.elidedText(text, Qt::ElideRight, inner.width()));
  return above;
}

PictureSpec spec_of(const PictureRequest& request, const QString& title) {
  return {request.format, request.size,        request.pixel_ratio,
          request.paper,  request.transparent, QApplication::palette().color(QPalette::Window),
          title};
}

}  // namespace

std::string scene_file(const ReportInput& input, const PictureRequest& request) {
  ScenePicture picture(input, input.current, request.theme, request.transparent);
  const SceneScale scale{request.pixel_ratio, text_scale_of(request)};
  PictureSpec spec = spec_of(request, input.heading());
  spec.background = ink_of(picture_colours(request).background);
  return make_picture(spec, [&](QPainter& painter) {
    picture.paint(painter, paint_caption(painter, input, colour_meaning(input), request), scale);
  });
}

std::string charts_file(const ReportInput& input, const PictureRequest& request) {
  ChartsPage page;
  page.set_runs(input, input.current);
  const QSize least = page.minimumSizeHint();
  const QSize size = request.size.toSize();
  if (size.width() < least.width() || size.height() < least.height()) {
    throw InputError(message(NC_("core",
                                 "charts of {} x {} units are too small; they need at least {} x {}: use a "
                                 "larger --size or a smaller --scale"),
                             size.width(), size.height(), least.width(), least.height()));
  }
  constexpr double enough_for_shapes = 2;  // columns of a curve per unit, if each is a shape
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

LensShot lens_shot(const ReportInput& input, double time) {
  std::vector<const Run*> runs;
  std::vector<LensLook> looks;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    const ReportRun& run = input.runs[i];
    if (run.shown->run.trajectory->path().empty()) {
      continue;  // the control does not run it
    }
    shown = i == input.current ? runs.size() : shown;
    runs.push_back(&run.shown->run);
    looks.push_back({lettered_title(input, i), run.colour, run_dashes(i)});
  }
  return {lens_at(runs, shown, time), std::move(looks)};
}

ReportPicture lens_picture(std::shared_ptr<const LensShot> shot, const QSizeF& size) {
  return {size, false, [shot = std::move(shot), size](QPainter& painter, double) {
            constexpr double scale = 0.8;
            painter.setFont(paper_font(10));
            LensPicture(shot->lens, shot->looks, scale)
                .paint(painter, QRectF(QPointF(), size), QApplication::palette());
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(QColor(0xc8, 0xcd, 0xd2), 1));
            painter.drawRect(QRectF(QPointF(), size).adjusted(0.5, 0.5, -0.5, -0.5));
          }};
}

namespace {

std::string lens_file(const ReportInput& input, const LensShot& shot, const PictureRequest& request,
                      const QString& place = {}) {
  PictureSpec spec = spec_of(request, input.heading());
  spec.background = QApplication::palette().color(QPalette::Base);
  return make_picture(spec, [&](QPainter& painter) {
    const QRectF above = paint_caption(painter, input, PictureCaption::tr("run"), request, place);
    painter.setFont(QApplication::font());
    LensPicture(shot.lens, shot.looks, text_scale_of(request)).paint(painter, above, QApplication::palette());
  });
}

/// A place along the path of one run; `name`: of the place.
std::string place_file(const ReportInput& input, const SlowPlace& place, const QString& name,
                       const PictureRequest& request) {
  ReportInput seen = at_place(without_other_runs(input), place);
  seen.texts = input.texts;  // the legend of a report is next to its picture
  seen.texts.start.clear();  // rarely in sight
  ScenePicture picture(seen, seen.current, request.theme, request.transparent);
  const SceneScale scale{request.pixel_ratio, text_scale_of(request)};
  PictureSpec spec = spec_of(request, input.heading());
  spec.background = ink_of(picture_colours(request).background);
  return make_picture(spec, [&](QPainter& painter) {
    const QString colours = PictureCaption::tr("%1, pink the place").arg(colour_meaning(seen));
    const QRectF above = paint_caption(painter, input, colours, request, name);
    show_place(picture, place, above.size(), scale);
    picture.paint(painter, above, scale);
  });
}

}  // namespace

std::string lens_file(const ReportInput& input, double time, const PictureRequest& request) {
  return lens_file(input, lens_shot(input, time), request);
}

std::string place_file(const ReportInput& asked, std::size_t number, const PictureRequest& request) {
  const ReportInput input = with_time_report(with_recommended_run(asked), false);
  const PlaceShot shot = place_shot(input, number);
  const QString name = PictureCaption::tr("Place %1, line %2").arg(number).arg(shot.place.line);
  return shot.lens ? lens_file(input, *shot.lens, request, name)
                   : place_file(input, shot.place, name, request);
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
