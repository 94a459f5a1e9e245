#pragma once

#include <cstdint>
#include <string_view>

namespace feedscope {

/// Where the times of the samples of a trace come from, the first of these that there is.
enum class TraceClock : std::uint8_t {
  times,    ///< the file has a time for each sample, and no rate was given
  option,   ///< a rate or period was given
  machine,  ///< the servo period of the machine
  assumed,  ///< nothing says it
};

/// "times", "option", "machine", "assumed": for files.
std::string_view to_string(TraceClock clock);
/// For people, translatable: "servo period of the machine".
std::string_view title_of(TraceClock clock);

/// How often a trace was sampled.
struct SamplingRate {
  double period = 0;  ///< between two samples: the median [s]; 0: there are none
  TraceClock clock = TraceClock::times;
};

}  // namespace feedscope
