#pragma once

#include <QString>
#include <string>

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// `html` with the pictures inside: one file that browsers show without any other.
std::string report_html(QString html, const ReportPictures& pictures);

}  // namespace feedscope::ui
