#pragma once

#include <QColor>
#include <QSizeF>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "ui/scene/picture.h"

class QImage;
class QPainter;

namespace feedscope::ui {

/// `pages`: RecordedPages, printed by the window.
enum class PictureFormat : std::uint8_t { png, svg, pdf, pages };

/// By the ending of a file's name, in either case. Throws InputError for any other ending.
PictureFormat picture_format_of(const std::string& name);

/// A picture to paint, and the format of its file.
struct PictureSpec {
  PictureFormat format = PictureFormat::png;
  QSizeF size;  ///< area of the painter, in units of 1/96 inch before `scale`
  /// Pixels of a PNG file per unit; in SVG and PDF files, of their raster parts.
  double scale = 1;
  /// Size on paper [mm] for SVG and PDF; none: 96 units per inch.
  std::optional<QSizeF> paper;
  bool transparent = false;  ///< else first filled with `background`
  QColor background = Qt::white;
  QString title;  ///< of SVG and PDF files
};

/// Removes the transparency.
Picture picture_of(const QImage& image);

/// Begins painting on an image with `ratio` pixels per unit of the painter. A ratio below 1 reduces;
/// QImage::setDevicePixelRatio() alone would crop.
void begin_units(QPainter& painter, QImage& image, double ratio);

/// The bytes of the file; the same painting gives the same bytes.
std::string make_picture(const PictureSpec& spec, const std::function<void(QPainter&)>& paint);

}  // namespace feedscope::ui
