#pragma once

#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// A card for each thing that the current run loses time to, that which loses most first: what its places
/// have in common, the worst of them explained, and that one in a picture. Where there are few such things,
/// further places of them.
QString cards_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
