#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/trace/table_columns.h"
#include "core/trace/trace_builder.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// A used channel of a file, with its quantity.
struct UsedChannel {
  FoundColumn channel;
  TraceQuantity quantity = TraceQuantity::x;
};

/// Quantities of the channels with these titles: as assigned in `asked` by number or title, else from the
/// titles. Notes them in `builder`. Throws InputError if a requested channel is missing, or none is a
/// position.
std::vector<UsedChannel> used_channels(const std::vector<std::string>& titles, const TraceColumns& asked,
                                       const std::string& name, TraceBuilder& builder);

}  // namespace feedscope
