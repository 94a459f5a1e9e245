#pragma once

#include <QTextDocument>
#include <memory>
#include <vector>

#include "ui/paper/page_flow.h"
#include "ui/paper/pdf_tags.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// Lays HTML out in the width of a report, on an endless page.
void set_on_paper(QTextDocument& document, QString html);

/// HTML with its pictures, laid out in the width of a report and cut into pages.
class PagedDocument {
 public:
  static constexpr double print_ratio = 300.0 / 96;  ///< 300 dots per inch

  /// `pictures` outlives this. `raster_ratio`: pixels of rasters per 1/96 inch.
  PagedDocument(QString html, const ReportPictures& pictures, const Paper& paper = {},
                double raster_ratio = print_ratio);
  ~PagedDocument();

  const QTextDocument& text() const { return document_; }
  const std::vector<PagePart>& pages() const { return parts_; }

  /// A place of the text on the pages.
  struct Place {
    int page = 0;
    double top = 0;  ///< below the upper margin
  };
  Place place_of(double top) const;
  /// Makes draw() mark the parts of the pages (mark_tag) and returns their tags; none if that would change
  /// the layout.
  std::vector<PdfTag> add_tags();
  /// Draws a page between its margins, with its upper left corner at 0, 0. Throws as painting of pictures
  /// does.
  void draw(QPainter& painter, int page);

 private:
  class Pictures;

  void draw_part(QPainter& painter, double from, double to, double at);

  std::unique_ptr<Pictures> pictures_;
  QTextDocument document_;
  std::vector<PagePart> parts_;
};

}  // namespace feedscope::ui
