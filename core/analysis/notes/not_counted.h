#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/toolpath/machine_path.h"

namespace feedscope {

/// A kind of event or motion that the cycle time does not include.
struct NotCountedItem {
  std::string_view key;  ///< for files: "tool_change", "spindle_start", "stop", "machine_move", "plane_turn",
                         ///< "tip_following", "other_axis"
  std::size_t count = 0;      ///< of events; for other_axis, of axes
  std::string_view settings;  ///< that would provide the time; "" if none
};

/// Items that occur, in a fixed order.
std::vector<NotCountedItem> not_counted_items(const NotCounted& counts);
/// Text such as "2 tool changes, 1 program stop (M0, M1), motion of B, C"; empty if all time is counted.
Message describe(const NotCounted& counts);
/// "Not in the cycle time: 2 tool changes"; empty if all time is counted.
Message not_counted_note(const NotCounted& counts);

}  // namespace feedscope
