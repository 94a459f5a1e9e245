#pragma once

#include <QString>
#include <cstddef>
#include <vector>

class QPDF;
class QPainter;

namespace feedscope::ui {

/// What a part of a document is, for those who have it read to them.
struct PdfTag {
  QString type;              ///< of PDF 1.7: "H1", "P", "Figure", "TH", "TD"
  QString alternative = {};  ///< that is read instead of a figure
  int table = 0;             ///< of a cell: which table, from 1
  int row = 0;               ///< of a cell
};

/// Says in the page that is being painted on that all since the last mark belongs to the tag with this
/// number; QPdfWriter has no such thing. The mark is a rectangle far off the page, which add_tags() takes
/// out.
void mark_tag(QPainter& painter, std::size_t tag);

/// Turns the marks of all pages into marked contents, with `tags` in their order as the structure of the
/// document (ISO 32000-1, 14.6 to 14.8). What belongs to none is an artifact.
void add_tags(QPDF& pdf, const std::vector<PdfTag>& tags);

}  // namespace feedscope::ui
