#include "core/program/controls/grbl_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace feedscope {
namespace {

using Axes = GrblCommands::Axes;

/// A command that grbl 1.1 accepts, in tenths (G38.2: 382); no line has two of one group.
struct Command {
  int code;
  int group;
  Axes axes;  ///< use of the axis words
  void (*apply)(GrblCommands& asked, int code);
};

void nothing(GrblCommands& /*asked*/, int /*code*/) {}
void set_motion(GrblCommands& asked, int code) {
  asked.modes.motion = code / 10;
}
void set_plane(GrblCommands& asked, int code) {
  asked.modes.plane = code / 10;
}
void set_unit(GrblCommands& asked, int code) {
  asked.modes.inch = code == 200;
}
void set_offset(GrblCommands& asked, int code) {
  asked.modes.offset = static_cast<std::size_t>(code / 10 - 54);
}
void set_distance(GrblCommands& asked, int code) {
  asked.modes.incremental = code == 910;
}
void set_feed_mode(GrblCommands& asked, int code) {
  asked.modes.inverse_time = code == 930;
}
void set_spindle(GrblCommands& asked, int code) {
  asked.modes.spindle = code;
}
void set_coolant(GrblCommands& asked, int code) {
  asked.modes.coolant = code != 9;
}

constexpr std::array g_commands{
    Command{0, 1, Axes::motion, set_motion},
    Command{10, 1, Axes::motion, set_motion},
    Command{20, 1, Axes::motion, set_motion},
    Command{30, 1, Axes::motion, set_motion},
    Command{382, 1, Axes::motion, set_motion},
    Command{383, 1, Axes::motion, set_motion},
    Command{384, 1, Axes::motion, set_motion},
    Command{385, 1, Axes::motion, set_motion},
    Command{800, 1, Axes::none, set_motion},
    Command{40, 0, Axes::none, [](GrblCommands& a, int) { a.dwell = true; }},
    Command{530, 0, Axes::none, [](GrblCommands& a, int) { a.machine_place = true; }},
    Command{100, 0, Axes::set_offset, nothing},
    Command{280, 0, Axes::home, nothing},
    Command{281, 0, Axes::none, [](GrblCommands& a, int) { a.save_home = true; }},
    Command{300, 0, Axes::second_home, nothing},
    Command{301, 0, Axes::none, [](GrblCommands& a, int) { a.save_second_home = true; }},
    Command{920, 0, Axes::shift, nothing},
    Command{921, 0, Axes::none, [](GrblCommands& a, int) { a.clear_shift = true; }},
    Command{170, 2, Axes::none, set_plane},
    Command{180, 2, Axes::none, set_plane},
    Command{190, 2, Axes::none, set_plane},
    Command{900, 3, Axes::none, set_distance},
    Command{910, 3, Axes::none, set_distance},
    Command{911, 4, Axes::none, nothing},
    Command{930, 5, Axes::none, set_feed_mode},
    Command{940, 5, Axes::none, set_feed_mode},
    Command{200, 6, Axes::none, set_unit},
    Command{210, 6, Axes::none, set_unit},
    Command{400, 7, Axes::none, nothing},
    Command{431, 8, Axes::tool_length, nothing},
    Command{490, 8, Axes::none, [](GrblCommands& a, int) { a.no_tool_length = true; }},
    Command{540, 12, Axes::none, set_offset},
    Command{550, 12, Axes::none, set_offset},
    Command{560, 12, Axes::none, set_offset},
    Command{570, 12, Axes::none, set_offset},
    Command{580, 12, Axes::none, set_offset},
    Command{590, 12, Axes::none, set_offset},
    Command{610, 13, Axes::none, nothing},
};

constexpr int stop_group = 14;
constexpr int spindle_group = 15;
constexpr int coolant_group = -1;  ///< may be repeated

constexpr std::array m_commands{
    Command{0, stop_group, Axes::none, [](GrblCommands& a, int) { a.stop = true; }},
    Command{1, stop_group, Axes::none, [](GrblCommands& a, int) { a.stop = true; }},
    Command{2, stop_group, Axes::none, [](GrblCommands& a, int) { a.end = true; }},
    Command{30, stop_group, Axes::none, [](GrblCommands& a, int) { a.end = true; }},
    Command{3, spindle_group, Axes::none, set_spindle},
    Command{4, spindle_group, Axes::none, set_spindle},
    Command{5, spindle_group, Axes::none, set_spindle},
    Command{8, coolant_group, Axes::none, set_coolant},
    Command{9, coolant_group, Axes::none, set_coolant},
};

/// Collects the commands of one line.
class Collector {
 public:
  explicit Collector(GrblCommands& asked) : asked_(asked) {}

  template <typename Table>
  std::optional<GrblError> take(const Table& table, int code, std::string name) {
    const auto* const found = std::ranges::find(table, code, &Command::code);
    if (found == table.end()) {
      return GrblError{20, Message::as_written(std::move(name))};
    }
    if (found->group >= 0) {
      if ((groups_ >> found->group & 1U) != 0) {
        return GrblError{21, Message::as_written(std::move(name))};
      }
      groups_ |= 1U << found->group;
    }
    if (found->axes != Axes::none) {
      if (asked_.axes != Axes::none) {
        return GrblError{24, Message::as_written(std::move(name))};
      }
      asked_.axes = found->axes;
    }
    found->apply(asked_, code);
    return std::nullopt;
  }

 private:
  GrblCommands& asked_;
  std::uint32_t groups_ = 0;
};

}  // namespace

std::optional<GrblError> find_grbl_commands(const GrblLine& line, const GrblModes& modes,
                                            GrblCommands& found) {
  found = GrblCommands{};
  found.modes = modes;
  Collector collector(found);
  for (const GrblLine::Code& g : line.g) {
    std::string name =
        g.decimal == 0 ? fmt::format("G{}", g.number) : fmt::format("G{}.{}", g.number, g.decimal);
    if (auto error = collector.take(g_commands, 10 * g.number + g.decimal, std::move(name))) {
      return error;
    }
  }
  for (const int m : line.m) {
    if (auto error = collector.take(m_commands, m, fmt::format("M{}", m))) {
      return error;
    }
  }
  const bool axis_words = line.has('X') || line.has('Y') || line.has('Z');
  if (axis_words && found.axes == Axes::none) {
    found.axes = Axes::motion;
  }
  return std::nullopt;
}

}  // namespace feedscope
