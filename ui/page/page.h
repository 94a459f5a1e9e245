#pragma once

#include <string>

#include "ui/report/report.h"

namespace feedscope::ui {

/// The HTML report of make_report() with an interactive view on top, for browsers that run scripts; in others
/// and in print it is the report. One file without external resources: a content security policy forbids
/// them. The same input and template give the same bytes. Throws Cancelled if `progress` is cancelled.
std::string make_page(const ReportInput& input, const ReportTemplate& page, Progress* progress = nullptr);

/// `html` with the view of `data`, page_data(), on top.
QString with_view(QString html, const QByteArray& data);

}  // namespace feedscope::ui
