#pragma once

#include <vector>

class QTextDocument;

namespace feedscope::ui {

/// What one page shows of a document that is laid out without pages. Lengths in units of the layout.
struct PagePart {
  double top = 0;
  double bottom = 0;       ///< of the last line on it
  double clip_bottom = 0;  ///< of what is drawn below that, as borders are
  double head_top = 0;     ///< heads of a table that goes on from the page before; drawn above the rest
  double head_bottom = 0;  ///< the same as head_top: none

  double head() const { return head_bottom - head_top; }
  double used() const { return head() + bottom - top; }
};

/// Cuts a document, laid out in its width, into pages of `height`; at least one. In order of weight: headings
/// stay with what follows them, rows of tables are whole, tables and figures are whole where a page holds
/// them, pages but the last are more than a quarter full, a sentence stays with the table or the picture
/// below it, paragraphs keep two lines together. Heads of tables that go on are repeated. A block or table
/// that asks for a page of its own gets one.
std::vector<PagePart> page_parts(const QTextDocument& document, double height);

}  // namespace feedscope::ui
