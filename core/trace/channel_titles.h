#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/trace/table_columns.h"
#include "core/trace/trace_builder.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// A channel of a file that is used, and as what.
struct UsedChannel {
  FoundColumn channel;
  TraceQuantity quantity = TraceQuantity::x;
};

/// Which of the channels with these titles are what: those that `asked` names by number or title, else as
/// their titles say. Tells `builder`. Throws InputError if a channel that is asked for is missing, or none is
/// a position.
std::vector<UsedChannel> used_channels(const std::vector<std::string>& titles, const TraceColumns& asked,
                                       const std::string& name, TraceBuilder& builder);

}  // namespace feedscope
