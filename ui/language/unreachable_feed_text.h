#pragma once

#include <QString>

#include "core/analysis/notes/unreachable_feed.h"

namespace feedscope::ui {

/// One sentence in the language and units of the user.
QString unreachable_feed_text(const UnreachableFeed& feed);

}  // namespace feedscope::ui
