#pragma once

class QTextDocument;

namespace feedscope::ui {

/// Puts page breaks before headings that would stand at the end of a page without what they head: the first
/// lines of a text, the first rows of a table, a picture. `height`: of the pages that the document has.
void keep_together(QTextDocument& document, double height);

}  // namespace feedscope::ui
