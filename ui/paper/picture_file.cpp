#include "ui/paper/picture_file.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "ui/language/language.h"
#include "ui/paper/pdf_file.h"
#include "ui/paper/recorded_pages.h"
#include "ui/paper/svg_device.h"

namespace feedscope::ui {

namespace {

constexpr double units_per_inch = 96;
constexpr double millimetres_per_inch = 25.4;

using Paint = std::function<void(QPainter&)>;

QSizeF millimetres_of(const PictureSpec& spec) {
  return spec.paper.value_or(spec.size * millimetres_per_inch / units_per_inch);
}

void paint_on(QPainter& painter, const PictureSpec& spec, const Paint& paint) {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing |
                         QPainter::SmoothPixmapTransform);
  if (!spec.transparent) {
    painter.fillRect(QRectF(QPointF(), spec.size), spec.background);
  }
  paint(painter);
}

std::string png_of(const PictureSpec& spec, const Paint& paint) {
  const QSize pixels(std::max(1, static_cast<int>(std::lround(spec.size.width() * spec.scale))),
                     std::max(1, static_cast<int>(std::lround(spec.size.height() * spec.scale))));
  QImage image(pixels, spec.transparent ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
  image.fill(spec.transparent ? QColor(Qt::transparent) : spec.background);
  QPainter painter;
  begin_units(painter, image, spec.scale);
  paint_on(painter, spec, paint);
  painter.end();
  image.setDevicePixelRatio(1);
  if (!spec.paper && !spec.transparent) {
    return to_png(picture_of(image));  // the same bytes as for pictures of the 3D view alone
  }
  const double paper = pixels.width() / millimetres_of(spec).width() * 1000;
  image.setDotsPerMeterX(static_cast<int>(std::lround(paper)));
  image.setDotsPerMeterY(static_cast<int>(std::lround(paper)));
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data().toStdString();
}

std::string svg_of(const PictureSpec& spec, const Paint& paint) {
  const auto length = [&](double paper, double units) {
    return spec.paper ? QStringLiteral("%1mm").arg(paper) : QString::number(units);
  };
  const QSizeF paper = millimetres_of(spec);
  SvgDevice device(spec.size, spec.title, length(paper.width(), spec.size.width()),
                   length(paper.height(), spec.size.height()));
  QPainter painter(&device);
  paint_on(painter, spec, paint);
  painter.end();
  return device.svg().toStdString();
}

std::string pdf_of(const PictureSpec& spec, const Paint& paint) {
  constexpr int resolution = 1200;
  const StableOrder order;
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const QSizeF paper = millimetres_of(spec);
  QPdfWriter writer(&buffer);
  writer.setResolution(resolution);
  writer.setPageSize(QPageSize(paper, QPageSize::Millimeter, {}, QPageSize::ExactMatch));
  writer.setPageMargins({});
  QPainter painter(&writer);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  const double unit = paper.width() / millimetres_per_inch * resolution / spec.size.width();
  painter.scale(unit, unit);
  paint_on(painter, spec, paint);
  painter.end();
  return finished_pdf(
      buffer.data().toStdString(),
      {.title = spec.title, .author = {}, .date = {}, .outline = {}, .language = spoken_language()});
}

std::string pages_of(const PictureSpec& spec, const Paint& paint) {
  RecordedPages pages(spec.title, millimetres_of(spec));
  constexpr double no_printer_reaches = 8;  // [mm] from the sheet's edges
  pages.add(
      spec.size, [&](QPainter& painter) { paint_on(painter, spec, paint); }, no_printer_reaches);
  return pages.bytes();
}

}  // namespace

PictureFormat picture_format_of(const std::string& name) {
  const QString file = QString::fromStdString(name).toLower();
  for (const auto& [ending, format] :
       {std::pair(".png", PictureFormat::png), std::pair(".svg", PictureFormat::svg),
        std::pair(".pdf", PictureFormat::pdf)}) {
    if (file.endsWith(QLatin1String(ending))) {
      return format;
    }
  }
  throw InputError(
      message(NC_("core", "cannot write '{}' as a picture; its name must end in .png, .svg or .pdf"), name));
}

Picture picture_of(const QImage& image) {
  const QImage rgb = image.convertToFormat(QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(rgb.width()) * 3;
  Picture picture{{rgb.width(), rgb.height()}, {}};
  for (int y = 0; y < rgb.height(); ++y) {
    const uchar* line = rgb.constScanLine(y);
    picture.rgb.insert(picture.rgb.end(), line, line + row);
  }
  return picture;
}

void begin_units(QPainter& painter, QImage& image, double ratio) {
  const double enlarged = std::max(1.0, ratio);  // QPainter treats a ratio below 1 as 1
  image.setDevicePixelRatio(enlarged);
  painter.begin(&image);
  painter.scale(ratio / enlarged, ratio / enlarged);
}

std::string make_picture(const PictureSpec& spec, const Paint& paint) {
  switch (spec.format) {
    case PictureFormat::svg:
      return svg_of(spec, paint);
    case PictureFormat::pdf:
      return pdf_of(spec, paint);
    case PictureFormat::pages:
      return pages_of(spec, paint);
    case PictureFormat::png:
      break;
  }
  return png_of(spec, paint);
}

}  // namespace feedscope::ui
