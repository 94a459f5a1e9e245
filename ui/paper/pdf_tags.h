#pragma once

#include <QString>
#include <cstddef>
#include <vector>

class QPDF;
class QPainter;

namespace feedscope::ui {

/// Meaning of a part of a document, for screen readers.
struct PdfTag {
  QString type;              ///< of PDF 1.7: "H1", "P", "Figure", "TH", "TD"
  QString alternative = {};  ///< read aloud instead of a figure
  int table = 0;             ///< of a cell: number of its table, from 1
  int row = 0;               ///< of a cell
};

/// Marks in the painted page that everything since the last mark belongs to this tag, which QPdfWriter cannot
/// express. The mark is a rectangle far outside the page; add_tags() removes it.
void mark_tag(QPainter& painter, std::size_t tag);

/// Turns the marks of all pages into marked contents, with `tags` in order as the structure of the document
/// (ISO 32000-1, 14.6 to 14.8). Contents without a tag are artifacts.
void add_tags(QPDF& pdf, const std::vector<PdfTag>& tags);

}  // namespace feedscope::ui
