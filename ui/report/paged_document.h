#pragma once

#include <QTextDocument>
#include <memory>
#include <vector>

#include "ui/report/page_flow.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

// Pages of A4 [1/96 inch].
inline constexpr double page_height = 297 / 25.4 * 96;
inline constexpr double page_margin_top = 62;
inline constexpr double page_margin_bottom = 60;
/// Of what stands between the margins.
inline constexpr double page_contents_height = page_height - page_margin_top - page_margin_bottom;

/// Lays HTML out in the width of a report, on a page without end.
void set_on_paper(QTextDocument& document, QString html);

/// HTML with its pictures, laid out in the width of a report and cut into pages.
class PagedDocument {
 public:
  static constexpr double print_ratio = 300.0 / 96;  ///< 300 dots an inch

  /// `pictures` outlive this. `raster_ratio`: pixels of rasters to 1/96 inch.
  PagedDocument(QString html, const ReportPictures& pictures, double raster_ratio = print_ratio);
  ~PagedDocument();

  const QTextDocument& text() const { return document_; }
  const std::vector<PagePart>& pages() const { return parts_; }

  /// A place of the text on the pages.
  struct Place {
    int page = 0;
    double top = 0;  ///< below the upper margin
  };
  Place place_of(double top) const;
  /// What is between the margins of a page, its upper left corner at 0, 0. Throws what painting pictures
  /// throws.
  void draw(QPainter& painter, int page);

 private:
  class Pictures;

  void draw_part(QPainter& painter, double from, double to, double at);

  std::unique_ptr<Pictures> pictures_;
  QTextDocument document_;
  std::vector<PagePart> parts_;
};

}  // namespace feedscope::ui
