#pragma once

#include <QByteArray>
#include <QList>
#include <QPicture>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <functional>
#include <string>

class QPainter;
class QPrinter;

namespace feedscope::ui {

/// Pages of a document as painting commands, passed from the process that lays them out to the one that
/// prints them: shapes, text and bitmaps are preserved.
class RecordedPages {
 public:
  /// Ending of their files, without the point; `feedscope render`, `report` and `lessons` write such a file
  /// for --out FILE.feedpages. Only for the same build of Feedscope.
  static constexpr const char* ending = "feedpages";

  RecordedPages() = default;
  /// `paper`: of every page [mm].
  RecordedPages(QString title, const QSizeF& paper) : title_(std::move(title)), paper_(paper) {}

  /// Adds a page; `size`: painting area of `paint`, which fills the paper except for `margin` [mm] on all
  /// sides.
  void add(const QSizeF& size, const std::function<void(QPainter&)>& paint, double margin = 0);
  qsizetype count() const { return pages_.size(); }
  const QString& title() const { return title_; }
  const QSizeF& paper() const { return paper_; }
  bool landscape() const { return paper_.width() > paper_.height(); }

  /// Draws a page in the centre of `area`, as large as fits.
  void draw(QPainter& painter, qsizetype page, const QRectF& area) const;
  /// Prints all pages, or the printer's range, each on one sheet.
  void print(QPrinter& printer) const;

  std::string bytes() const;
  /// Throws InputError for anything but the result of bytes().
  static RecordedPages from_bytes(const QByteArray& bytes);

 private:
  QString title_;
  QSizeF paper_;
  QList<QPicture> pages_;
};

}  // namespace feedscope::ui
