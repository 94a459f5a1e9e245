#pragma once

#include <QByteArray>

#include "core/base/progress.h"
#include "ui/report/report_input.h"

namespace feedscope::ui {

/// Nodes of all runs together; of a long program 8 bytes each in a page.
inline constexpr std::size_t most_page_nodes = 350'000;

/// What the page of a report shows of its runs, as README.md beside this file says: PageData::packed().
/// The same input gives the same bytes. Throws Cancelled if `progress` is cancelled.
QByteArray page_data(const ReportInput& input, Progress* progress = nullptr,
                     std::size_t most_nodes = most_page_nodes);

}  // namespace feedscope::ui
