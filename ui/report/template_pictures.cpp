#include "ui/report/template_pictures.h"

#include <fmt/format.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>

#include "core/base/error.h"
#include "ui/report/svg_picture.h"

namespace feedscope::ui {

namespace {

constexpr qint64 largest_picture = 64 << 20;  // [bytes]

QString type_of(const QByteArray& bytes) {
  return bytes.startsWith("\x89PNG")      ? QStringLiteral("image/png")
         : bytes.startsWith("\xff\xd8")   ? QStringLiteral("image/jpeg")
         : bytes.startsWith("GIF8")       ? QStringLiteral("image/gif")
         : bytes.mid(8, 4) == "WEBP"      ? QStringLiteral("image/webp")
         : bytes.startsWith("BM")         ? QStringLiteral("image/bmp")
         : bytes.left(1024).contains("<") ? QStringLiteral("image/svg+xml")
                                          : QStringLiteral("image/unknown");
}

/// A file as a data: URL. Throws InputError with the reason, without the file's name.
QString picture_url(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    throw InputError(message(NC_("core", "cannot be read: {}"), file.errorString().toStdString()));
  }
  if (file.size() > largest_picture) {
    throw InputError(
        message(NC_("core", "has {} bytes, and a picture may have {}"), file.size(), largest_picture));
  }
  const QByteArray bytes = file.readAll();
  if (!InlinePicture::from_bytes(bytes)) {
    throw InputError(NC_("core", "is not a picture; PNG, JPEG, SVG and other formats of Qt are supported"));
  }
  return QStringLiteral("data:%1;base64,%2").arg(type_of(bytes), QString::fromLatin1(bytes.toBase64()));
}

class PictureReader {
 public:
  PictureReader(const QString& text, const QString& name) : text_(text), name_(name) {}

  QString read() {
    static const QRegularExpression tag(
        QStringLiteral("<(img|link)\\b[^>]*?\\b(?:src|href)\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)')[^>]*>"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::DotMatchesEverythingOption);
    QString result;
    qsizetype at = 0;
    for (auto found = tag.globalMatch(text_); found.hasNext();) {
      const QRegularExpressionMatch match = found.next();
      place_ = match.capturedStart();
      const int group = match.hasCaptured(2) && match.capturedStart(2) >= 0 ? 2 : 3;
      if (match.captured(1).compare(QStringLiteral("link"), Qt::CaseInsensitive) == 0) {
        check_link(match.captured());
        continue;
      }
      result += text_.mid(at, match.capturedStart(group) - at) + inside(match.captured(group));
      at = match.capturedEnd(group);
    }
    return result + text_.mid(at);
  }

 private:
  [[noreturn]] void fail(const QString& source, const Message& reason) const {
    const qsizetype line = text_.left(place_).count('\n') + 1;
    throw InputError(at_place(fmt::format("{}:{}", name_.toStdString(), line),
                              message(NC_("core", "'{}' {}"), source.toStdString(), reason)));
  }

  void check_link(const QString& tag) const {
    if (tag.contains(QStringLiteral("stylesheet"), Qt::CaseInsensitive)) {
      fail(tag, NC_("core", "is an external style sheet; put its rules into <style>"));
    }
  }

  QString inside(const QString& source) const {
    if (source.contains(QStringLiteral("{{")) || source.startsWith(QStringLiteral("picture:"))) {
      return source;
    }
    if (source.startsWith(QStringLiteral("data:"))) {
      Message reason =
          NC_("core", "contains no picture; PNG, JPEG, SVG and other formats of Qt are supported");
      try {
        if (InlinePicture::from_url(source)) {
          return source;
        }
      } catch (const InputError& error) {
        reason = error.message();
      }
      fail(source.left(40), reason);
    }
    if (source.contains(QStringLiteral("://"))) {
      fail(source, NC_("core", "is a URL; save the picture in the template's folder and give its file name"));
    }
    const QString path = QFileInfo(name_).absoluteDir().filePath(source);
    try {
      return picture_url(path);
    } catch (const InputError& error) {
      const bool found = QFileInfo::exists(path);
      fail(source, found ? error.message()
                         : message(NC_("core", "{}; pictures are looked for in the template's folder"),
                                   error.message()));
    }
  }

  const QString& text_;
  const QString& name_;
  qsizetype place_ = 0;
};

}  // namespace

QString with_pictures_inside(const QString& text, const QString& name) {
  return PictureReader(text, name).read();
}

QString inline_picture_url(const QString& file) {
  try {
    return picture_url(file);
  } catch (const InputError& error) {
    throw InputError(message(NC_("core", "picture '{}' {}"), file.toStdString(), error.message()));
  }
}

std::optional<InlinePicture> InlinePicture::from_url(const QString& url) {
  const qsizetype comma = url.indexOf(',');
  if (!url.startsWith(QStringLiteral("data:")) || comma < 0) {
    return std::nullopt;
  }
  const QByteArray data = url.mid(comma + 1).toLatin1();
  const bool coded = url.left(comma).endsWith(QStringLiteral(";base64"));
  return from_bytes(coded ? QByteArray::fromBase64(data) : QByteArray::fromPercentEncoding(data));
}

std::optional<InlinePicture> InlinePicture::from_bytes(const QByteArray& bytes) {
  InlinePicture picture;
  picture.bytes_ = bytes;
  picture.vectors_ = type_of(bytes) == QStringLiteral("image/svg+xml");
  picture.size_ = picture.vectors_ ? svg_size(bytes) : QSizeF(QImage::fromData(bytes).size());
  return picture.size_.isEmpty() ? std::nullopt : std::optional(picture);
}

void InlinePicture::draw(QPainter& painter, const QRectF& place) const {
  if (vectors_) {
    draw_svg(painter, bytes_, place);
  } else {
    painter.drawImage(place, QImage::fromData(bytes_));
  }
}

}  // namespace feedscope::ui
