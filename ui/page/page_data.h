#pragma once

#include <QByteArray>

#include "core/base/progress.h"
#include "ui/report/report_input.h"

namespace feedscope::ui {

/// Nodes of all runs together; in a page about 8 bytes each for a long program.
inline constexpr std::size_t most_page_nodes = 400'000;

/// Data of a report's runs for its page, in the format of README.md in this folder: PageData::packed().
/// The same input gives the same bytes. Throws Cancelled if `progress` is cancelled.
QByteArray page_data(const ReportInput& input, Progress* progress = nullptr,
                     std::size_t most_nodes = most_page_nodes);

}  // namespace feedscope::ui
