#include "ui/report/report_html.h"

#include "ui/paper/picture_file.h"

namespace feedscope::ui {
namespace {

QString png_url(const QByteArray& picture) {
  return QStringLiteral("png;base64,") + QString::fromLatin1(picture.toBase64());
}

/// SVG is mostly numbers, which need no coding: base64 would be a third longer. Quotes attributes with the
/// character that needs no coding, if no text contains it.
QString svg_url(QByteArray picture) {
  if (!picture.contains('\'')) {
    picture.replace('"', '\'');
  }
  picture.replace("\n", "");
  return QStringLiteral("svg+xml,") + QString::fromLatin1(picture.toPercentEncoding(" !$'()*+,/:;=?@"));
}

}  // namespace

std::string report_html(QString html, const ReportPictures& pictures) {
  constexpr double pixel_ratio = 2;  // sharp on high-resolution screens
  for (const auto& [name, picture] : pictures.all()) {
    PictureSpec spec;
    spec.format = picture.raster ? PictureFormat::png : PictureFormat::svg;
    spec.size = picture.size;
    spec.scale = pixel_ratio;
    const std::string bytes =
        make_picture(spec, [&](QPainter& painter) { pictures.paint(name, painter, pixel_ratio); });
    const QByteArray data = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
    html.replace(QStringLiteral("\"picture:%1\"").arg(name),
                 QStringLiteral("\"data:image/%1\"").arg(picture.raster ? png_url(data) : svg_url(data)));
  }
  return html.toStdString();
}

}  // namespace feedscope::ui
