#pragma once

#include <QString>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// Where a page of a template may begin.
inline const QString page_mark = QStringLiteral("<!-- page -->");

/// `html` of a report with its elastic pictures as high as their pages have room for. What follows a
/// page_mark begins a page where the one before is filled to three quarters or more, else it goes on there.
QString with_filled_pages(const QString& html, ReportPictures& pictures, const Paper& paper = {});

}  // namespace feedscope::ui
