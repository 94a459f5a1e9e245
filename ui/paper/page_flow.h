#pragma once

#include <vector>

class QTextDocument;

namespace feedscope::ui {

/// The part of a document without page breaks that one page shows. Lengths in units of the layout.
struct PagePart {
  double top = 0;
  double bottom = 0;       ///< of the last line on it
  double clip_bottom = 0;  ///< end of drawing, such as borders, below that
  double head_top = 0;     ///< heads of a table continued from the previous page; drawn above the rest
  double head_bottom = 0;  ///< equal to head_top: none

  double head() const { return head_bottom - head_top; }
  double used() const { return head() + bottom - top; }
};

/// Cuts a document, laid out in its width, into pages of `height`; at least one. By priority: headings stay
/// with the text after them; rows of tables are whole; tables and figures that fit on a page are whole; pages
/// except the last are more than a quarter full; a sentence stays with the table or picture below it;
/// paragraphs keep two lines together. Heads of continued tables are repeated. A block or table with a forced
/// break begins a page.
std::vector<PagePart> page_parts(const QTextDocument& document, double height);

}  // namespace feedscope::ui
