#pragma once

#include <cstdint>
#include <vector>

#include "core/trace/trace_builder.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// A signal with times of its own.
struct TraceChannel {
  TraceQuantity quantity = TraceQuantity::x;
  std::vector<double> time;              ///< [s]
  std::vector<double> value;             ///< inside units
  std::vector<std::uint32_t> line = {};  ///< of the file, where the values stand
};

/// Adds the samples of the channel with the most samples, the others interpolated at its times: several
/// rates in one file.
void add_channels(const std::vector<TraceChannel>& channels, TraceBuilder& builder);

}  // namespace feedscope
