#include "core/analysis/notes/not_counted.h"

#include <algorithm>
#include <array>

#include "core/program/path/other_axes.h"

namespace feedscope {

namespace {

struct Kind {
  std::size_t NotCounted::*count;
  std::string_view key;
  Message (*text)(std::size_t count);
  std::string_view settings;
};

constexpr std::array kinds{
    Kind{&NotCounted::tool_changes, "tool_change",
         [](std::size_t count) {
           return count == 1 ? message(NC_("core", "{} tool change"), count)
                             : message(NC_("core", "{} tool changes"), count);
         },
         "tool_change_time_s"},
    Kind{&NotCounted::spindle_starts, "spindle_start",
         [](std::size_t count) {
           return count == 1 ? message(NC_("core", "{} spindle start"), count)
                             : message(NC_("core", "{} spindle starts"), count);
         },
         "spindle_start_time_s"},
    Kind{&NotCounted::stops, "stop",
         [](std::size_t count) {
           return count == 1 ? message(NC_("core", "{} program stop (M0, M1)"), count)
                             : message(NC_("core", "{} program stops (M0, M1)"), count);
         },
         ""},
    Kind{&NotCounted::machine_moves, "machine_move",
         [](std::size_t count) {
           return count == 1 ? message(NC_("core", "{} move to or from a machine position"), count)
                             : message(NC_("core", "{} moves to or from machine positions"), count);
         },
         "home_x_mm tool_change_x_mm part_zero_x_mm"},
    Kind{&NotCounted::plane_turns, "plane_turn",
         [](std::size_t count) {
           return count == 1 ? message(NC_("core", "{} turn of rotary axes for a tilted plane"), count)
                             : message(NC_("core", "{} turns of rotary axes for tilted planes"), count);
         },
         ""},
    Kind{&NotCounted::tip_followings, "tip_following",
         [](std::size_t count) {
           return count == 1 ? message(NC_("core",
                                           "{} possible delay by X, Y and Z that follow rotary axes (tool "
                                           "length or part zero unknown)"),
                                       count)
                             : message(NC_("core",
                                           "{} possible delays by X, Y and Z that follow rotary axes (tool "
                                           "length or part zero unknown)"),
                                       count);
         },
         "tool_length_mm part_zero_x_mm part_zero_y_mm part_zero_z_mm"}};

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

Message describe(const NotCounted& counts) {
  std::vector<Message> texts;
  for (const Kind& kind : kinds) {
    if (const std::size_t count = counts.*kind.count; count > 0) {
      texts.push_back(kind.text(count));
    }
  }
  if (!counts.other_axes.empty()) {
    std::vector<Message> axes;
    for (const std::string& axis : counts.other_axes) {
      axes.push_back(axis == orientation_axis ? Message(NC_("core", "tool orientation"))
                                              : Message::as_written(axis));
    }
    texts.push_back(message(NC_("core", "motion of {}"), enumerated(axes)));
  }
  return enumerated(texts);
}

Message not_counted_note(const NotCounted& counts) {
  Message events = describe(counts);
  return events.empty() ? events : message(NC_("core", "Not in the cycle time: {}"), std::move(events));
}

}  // namespace feedscope
