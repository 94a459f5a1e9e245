#include "core/trace/trace_clock.h"

#include <array>

#include "core/base/translatable.h"

namespace feedscope {
namespace {

struct ClockNames {
  std::string_view key;
  std::string_view title;
};
/// In the order of TraceClock.
constexpr std::array clock_names{
    ClockNames{"times", QT_TRANSLATE_NOOP("core", "times of the trace")},
    ClockNames{"option", QT_TRANSLATE_NOOP("core", "rate as given")},
    ClockNames{"machine", QT_TRANSLATE_NOOP("core", "servo period of the machine")},
    ClockNames{"assumed", QT_TRANSLATE_NOOP("core", "assumed rate")}};

}  // namespace

std::string_view to_string(TraceClock clock) {
  return clock_names[static_cast<std::size_t>(clock)].key;
}

std::string_view title_of(TraceClock clock) {
  return clock_names[static_cast<std::size_t>(clock)].title;
}

}  // namespace feedscope
