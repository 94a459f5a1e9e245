#pragma once

#include <QFont>

namespace feedscope::ui {

/// The same font without ligatures: "ff" remains two letters for search and copying in a PDF file.
QFont without_ligatures(QFont font);

/// The font of reports, sheets and pictures, installed with Feedscope everywhere.
QFont paper_font(int pixels, bool bold = false);

}  // namespace feedscope::ui
