#pragma once

#include <cstdint>
#include <vector>

#include "core/trace/trace_builder.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// A signal with its own times.
struct TraceChannel {
  TraceQuantity quantity = TraceQuantity::x;
  std::vector<double> time;              ///< [s]
  std::vector<double> value;             ///< internal units
  std::vector<std::uint32_t> line = {};  ///< line of each value in the file
};

/// Adds the samples of the channel with the most samples and interpolates the others at its times, for files
/// with several rates.
void add_channels(const std::vector<TraceChannel>& channels, TraceBuilder& builder);

}  // namespace feedscope
