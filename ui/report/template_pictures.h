#pragma once

#include <QByteArray>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <optional>

class QPainter;

namespace feedscope::ui {

/// A page with the pictures that its <img> tags name read in: "logo.png" is looked for in the folder of
/// `name`, the page's file, and becomes a data: URL. What blocks put in ("picture:...") and what is a data:
/// URL already stays. Throws InputError with the file and the line for a picture that cannot be read or is
/// not one, an address in the web, and a style sheet outside the page, which pages of paper would miss.
QString with_pictures_inside(const QString& text, const QString& name);

/// The picture in `file` as a data: URL. Throws InputError naming it if it cannot be read or is no picture.
QString inline_picture_url(const QString& file);

/// The picture in a data: URL.
class InlinePicture {
 public:
  /// Empty if there is no picture in it.
  static std::optional<InlinePicture> from_url(const QString& url);
  /// The same of a file's contents.
  static std::optional<InlinePicture> from_bytes(const QByteArray& bytes);

  QSizeF size() const { return size_; }  ///< as it asks for [1/96 inch]
  void draw(QPainter& painter, const QRectF& place) const;

 private:
  QByteArray bytes_;
  QSizeF size_;
  bool vectors_ = false;
};

}  // namespace feedscope::ui
