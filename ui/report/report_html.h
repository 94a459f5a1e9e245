#pragma once

#include <QString>
#include <string>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// `html` with embedded pictures: a single file for browsers.
std::string report_html(QString html, const ReportPictures& pictures);

}  // namespace feedscope::ui
