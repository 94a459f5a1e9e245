#pragma once

#include <cstdint>
#include <string_view>

namespace feedscope {

/// Source of the sample times of a trace; the first available one is used.
enum class TraceClock : std::uint8_t {
  times,    ///< the file has a time for each sample, and no rate was given
  option,   ///< a rate or period was given
  machine,  ///< the servo period of the machine
  assumed,  ///< no source
};

/// Keys for files: "times", "option", "machine", "assumed".
std::string_view to_string(TraceClock clock);
/// Title for display, translatable: "servo period of the machine".
std::string_view title_of(TraceClock clock);

struct SamplingRate {
  double period = 0;  ///< median between two samples [s]; 0 without samples
  TraceClock clock = TraceClock::times;
};

}  // namespace feedscope
