#pragma once

class QPlainTextEdit;
class QTextBrowser;

namespace feedscope::ui {

/// Sets the height to that of the text, so that no scroll bar is needed.
void fit_to_text(QTextBrowser& browser);
/// Sets the height to that of the lines, at least three.
void fit_to_lines(QPlainTextEdit& field);

}  // namespace feedscope::ui
