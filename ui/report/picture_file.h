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

/// `pages`: RecordedPages, to be printed by the window.
enum class PictureFormat : std::uint8_t { png, svg, pdf, pages };

/// By the ending of a file's name, in capitals or not. Throws InputError for any other ending.
PictureFormat picture_format_of(const std::string& name);

/// A picture to be painted, and the file that it becomes.
struct PictureSpec {
  PictureFormat format = PictureFormat::png;
  QSizeF size;  ///< what the painter sees, in units of 1/96 inch before `scale`
  /// Pixels of a PNG file to a unit. In SVG and PDF files, pixels of what is a raster in any case.
  double scale = 1;
  /// Size on paper [mm] for SVG and PDF; none: 96 units an inch.
  std::optional<QSizeF> paper;
  bool transparent = false;  ///< else filled with `background` first
  QColor background = Qt::white;
  QString title;  ///< of SVG and PDF files
};

/// Without its transparency.
Picture picture_of(const QImage& image);

/// Begins to paint on an image with `ratio` pixels to a unit of the painter. A ratio below 1 reduces;
/// QImage::setDevicePixelRatio() alone would crop.
void begin_units(QPainter& painter, QImage& image, double ratio);

/// The bytes of the file; the same painting gives the same bytes.
std::string make_picture(const PictureSpec& spec, const std::function<void(QPainter&)>& paint);

}  // namespace feedscope::ui
