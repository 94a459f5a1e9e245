#include "ui/report/report_html.h"

#include "ui/report/picture_file.h"

namespace feedscope::ui {

std::string report_html(QString html, const ReportPictures& pictures) {
  constexpr double pixel_ratio = 2;  // sharp on the screens of today
  for (const auto& [name, picture] : pictures.all()) {
    PictureSpec spec;
    spec.format = picture.raster ? PictureFormat::png : PictureFormat::svg;
    spec.size = picture.size;
    spec.scale = pixel_ratio;
    const std::string bytes =
        make_picture(spec, [&](QPainter& painter) { pictures.paint(name, painter, pixel_ratio); });
    const QString kind = picture.raster ? QStringLiteral("png") : QStringLiteral("svg+xml");
    const QByteArray data =
        QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())).toBase64();
    html.replace(QStringLiteral("\"picture:%1\"").arg(name),
                 QStringLiteral("\"data:image/%1;base64,%2\"").arg(kind, QString::fromLatin1(data)));
  }
  return html.toStdString();
}

}  // namespace feedscope::ui
