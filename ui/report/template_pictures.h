#pragma once

#include <QByteArray>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <optional>

class QPainter;

namespace feedscope::ui {

/// A page with the pictures of its <img> tags embedded: "logo.png", relative to the folder of the page's file
/// `name`, becomes a data: URL. Pictures of blocks ("picture:...") and data: URLs remain. Throws InputError
/// with the file and the line for a picture that cannot be read or is not one, a web address, and an external
/// style sheet, which paper would lack.
QString with_pictures_inside(const QString& text, const QString& name);

/// The picture in `file` as a data: URL. Throws InputError naming it if it cannot be read or is not a
/// picture.
QString inline_picture_url(const QString& file);

/// The picture in a data: URL.
class InlinePicture {
 public:
  /// Empty if the URL does not contain a picture.
  static std::optional<InlinePicture> from_url(const QString& url);
  /// Empty if the contents of a file are not a picture.
  static std::optional<InlinePicture> from_bytes(const QByteArray& bytes);

  QSizeF size() const { return size_; }  ///< preferred size [1/96 inch]
  void draw(QPainter& painter, const QRectF& place) const;

 private:
  QByteArray bytes_;
  QSizeF size_;
  bool vectors_ = false;
};

}  // namespace feedscope::ui
