#pragma once

#include <QString>
#include <string>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// `html` laid out on pages of A4 with title, page numbers and bookmarks from its headings. Headings stay
/// with what follows them, and rows of tables on one page where they fit on one.
std::string report_pdf(const QString& html, const ReportPictures& pictures, const ReportInput& input);

}  // namespace feedscope::ui
