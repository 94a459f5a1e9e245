#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// Mark in a template where a page may begin.
inline const QString page_mark = QStringLiteral("<!-- page -->");

/// `html` of a report, with elastic pictures as high as their pages permit. Text after a page_mark begins a
/// page if the previous one is at least three quarters full, else it continues there.
QString with_filled_pages(const QString& html, ReportPictures& pictures, const Paper& paper = {});

}  // namespace feedscope::ui
