#pragma once

#include <QFont>

namespace feedscope::ui {

/// The same font without ligatures: "ff" stays two letters when text is copied from a PDF file or searched.
QFont without_ligatures(QFont font);

/// The font of reports, sheets and pictures, which is on every machine that Feedscope is installed on.
QFont paper_font(int pixels, bool bold = false);

}  // namespace feedscope::ui
