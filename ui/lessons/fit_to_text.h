#pragma once

class QPlainTextEdit;
class QTextBrowser;

namespace feedscope::ui {

/// As high as its text, without a scroll bar of its own.
void fit_to_text(QTextBrowser& browser);
/// As high as its lines, three at least.
void fit_to_lines(QPlainTextEdit& field);

}  // namespace feedscope::ui
