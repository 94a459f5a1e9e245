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

/// Pages of a document as what was painted on them, from a process that lays them out to one that prints
/// them: shapes, text and bitmaps stay what they are.
class RecordedPages {
 public:
  /// Ending of files of them, without its point; `feedscope render`, `report` and `lessons` write such a file
  /// for --out FILE.feedpages. They are for the same build of Feedscope.
  static constexpr const char* ending = "feedpages";

  RecordedPages() = default;
  /// `paper`: of every page [mm].
  RecordedPages(QString title, const QSizeF& paper) : title_(std::move(title)), paper_(paper) {}

  /// One more page; `size`: of what `paint` sees, which fills the paper but for `margin` [mm] on all sides.
  void add(const QSizeF& size, const std::function<void(QPainter&)>& paint, double margin = 0);
  qsizetype count() const { return pages_.size(); }
  const QString& title() const { return title_; }
  const QSizeF& paper() const { return paper_; }
  bool landscape() const { return paper_.width() > paper_.height(); }

  /// A page, as large as fits into `area`, in its middle.
  void draw(QPainter& painter, qsizetype page, const QRectF& area) const;
  /// All pages, or those that the printer is asked for, each on a sheet of it.
  void print(QPrinter& printer) const;

  std::string bytes() const;
  /// Throws InputError for anything else than bytes().
  static RecordedPages from_bytes(const QByteArray& bytes);

 private:
  QString title_;
  QSizeF paper_;
  QList<QPicture> pages_;
};

}  // namespace feedscope::ui
