#include "core/analysis/notes/not_counted.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace feedscope {

namespace {

struct Kind {
  std::size_t NotCounted::*count;
  std::string_view key;
  std::string_view one;
  std::string_view several;
  std::string_view settings;
};

constexpr std::array kinds{
    Kind{&NotCounted::tool_changes, "tool_change", "tool change", "tool changes", "tool_change_time_s"},
    Kind{&NotCounted::spindle_starts, "spindle_start", "spindle start", "spindle starts",
         "spindle_start_time_s"},
    Kind{&NotCounted::stops, "stop", "program stop (M0, M1)", "program stops (M0, M1)", ""},
    Kind{&NotCounted::machine_moves, "machine_move", "move to or from a machine position",
         "moves to or from machine positions", "home_x_mm tool_change_x_mm part_zero_x_mm"},
    Kind{&NotCounted::plane_turns, "plane_turn", "turn of rotary axes for a tilted plane",
         "turns of rotary axes for tilted planes", ""},
    Kind{&NotCounted::tip_followings, "tip_following",
         "possible delay by X, Y and Z that follow rotary axes (tool length or part zero unknown)",
         "possible delays by X, Y and Z that follow rotary axes (tool length or part zero unknown)",
         "tool_length_mm part_zero_x_mm part_zero_y_mm part_zero_z_mm"},
};

}  // namespace

std::vector<NotCountedItem> not_counted_items(const NotCounted& counts) {
  std::vector<NotCountedItem> items;
  for (const Kind& kind : kinds) {
    if (counts.*kind.count > 0) {
      items.push_back({kind.key, counts.*kind.count, kind.settings});
    }
  }
  if (!counts.other_axes.empty()) {
    items.push_back({"other_axis", counts.other_axes.size(), ""});
  }
  return items;
}

std::string describe(const NotCounted& counts) {
  std::vector<std::string> texts;
  for (const Kind& kind : kinds) {
    const std::size_t count = counts.*kind.count;
    if (count > 0) {
      texts.push_back(fmt::format("{} {}", count, count == 1 ? kind.one : kind.several));
    }
  }
  if (!counts.other_axes.empty()) {
    texts.push_back(fmt::format("motion of {}", fmt::join(counts.other_axes, ", ")));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace feedscope
