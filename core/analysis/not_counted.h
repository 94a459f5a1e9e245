#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/toolpath/machine_toolpath.h"

namespace feedscope {

/// One kind of event whose time no cycle time contains.
struct NotCountedItem {
  std::string_view key;  ///< for files: "tool_change", "spindle_start", "stop", "machine_move"
  std::size_t count = 0;
  std::string_view settings;  ///< that would give the time; "" for none
};

/// Those that occur, in a fixed order.
std::vector<NotCountedItem> not_counted_items(const NotCounted& counts);
/// "2 tool changes, 1 stop (M0, M1)"; empty if all time is counted.
std::string describe(const NotCounted& counts);

}  // namespace feedscope
