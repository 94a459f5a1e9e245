#include "core/program/iso/language/system_variables.h"

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "core/program/text/read_fault.h"

namespace feedscope::iso {

namespace {

constexpr std::uint32_t first_of_control = 1000;  ///< Fanuc; lower ones are the program's own
constexpr std::uint32_t first_kept = 500;         ///< Fanuc; kept when the control is switched off

double in_unit(double mm, bool inch) {
  return inch ? mm / units::from_inch(1) : mm;
}

double motion_number(const ModalState& state) {
  switch (state.motion) {
    case MotionMode::cycle:
      return state.cycle_code / 10.0;
    case MotionMode::spline:
      return state.spline_code / 10.0;
    case MotionMode::none:
    case MotionMode::unread:
      return 80;
    case MotionMode::rapid:
      return 0;
    case MotionMode::line:
      return 1;
    case MotionMode::arc_cw:
      return 2;
    case MotionMode::arc_ccw:
      return 3;
  }
  return 80;
}

double plane_number(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return 17;
    case Plane::zx:
      return 18;
    case Plane::yz:
      return 19;
  }
  return 17;
}

double feed_mode_number(FeedMode mode) {
  switch (mode) {
    case FeedMode::inverse_time:
      return 93;
    case FeedMode::per_minute:
      return 94;
    case FeedMode::per_revolution:
    case FeedMode::per_tooth:
      return 95;
  }
  return 94;
}

}  // namespace

std::optional<SystemVariables::OffsetVariable> SystemVariables::offset_variable(std::uint32_t number) const {
  constexpr std::uint32_t first = 5221;    // G54
  constexpr std::uint32_t further = 7001;  // G54.1 P1
  constexpr std::uint32_t max_further = 48;
  constexpr std::uint32_t apart = 20;
  const bool linuxcnc = is_linuxcnc();
  const std::uint32_t count = linuxcnc ? Frames::work_offset_keys.size() : 6;
  const auto in_table = [&](std::uint32_t start, std::uint32_t entries) {
    return number >= start && number < start + apart * entries && (number - start) % apart < 3;
  };
  if (in_table(first, count)) {
    return OffsetVariable{Frames::work_offset_keys[(number - first) / apart],
                          static_cast<int>((number - first) % apart)};
  }
  if (!linuxcnc && in_table(further, max_further)) {
    const auto entry = static_cast<int>((number - further) / apart + 1);
    return OffsetVariable{Frames::further_work_offset(entry), static_cast<int>((number - further) % apart)};
  }
  return std::nullopt;
}

void SystemVariables::set(std::uint32_t number, double value, std::uint32_t column) {
  constexpr std::uint32_t alarm = 3000;
  const std::optional<OffsetVariable> offset = offset_variable(number);
  if (!is_linuxcnc() && number == alarm) {
    raise_alarm(value, column);
  } else if (offset && !is_linuxcnc()) {
    coordinates_.set_offset_coordinate(offset->key, offset->axis, modal_.to_mm(is_null(value) ? 0 : value));
  } else if (number == 0 || offset || built_in(number)) {
    throw ReadFault{"variable", column, message(NC_("core", "#{} is read-only"), number),
                    NC_("core", "the assignment is skipped; use another variable")};
  } else {
    variables_.set(number, value);
  }
}

double SystemVariables::position_of(int axis) const {
  return in_unit(path().position()[axis], modal_.inch);
}

double SystemVariables::feed_word() const {
  const double feed = path().feed();
  switch (path().feed_mode()) {
    case FeedMode::per_minute:
      return in_unit(units::to_mm_min(feed), modal_.inch);
    case FeedMode::inverse_time:
      return feed * 60;
    case FeedMode::per_revolution:
    case FeedMode::per_tooth:
      break;
  }
  return in_unit(feed, modal_.inch);
}

std::optional<double> SystemVariables::built_in(std::uint32_t number) const {
  if (const std::optional<OffsetVariable> variable = offset_variable(number)) {
    const std::optional<double> shift = coordinates_.offset_coordinate(variable->key, variable->axis);
    return shift ? std::optional(in_unit(*shift, modal_.inch)) : std::nullopt;
  }
  const auto axis_of = [&](std::uint32_t first) { return position_of(static_cast<int>(number - first)); };
  if (is_linuxcnc()) {
    if (number >= 5420 && number <= 5422) {
      return axis_of(5420);
    }
    if (number == 5220) {
      const auto* const key =
          std::find(Frames::work_offset_keys.begin(), Frames::work_offset_keys.end(), modal_.work_offset);
      return key == Frames::work_offset_keys.end()
                 ? 1.0
                 : static_cast<double>(key - Frames::work_offset_keys.begin() + 1);
    }
    return number == 5400 ? std::optional(modal_.tool) : std::nullopt;
  }
  if (number >= 5001 && number <= 5003) {
    return axis_of(5001);
  }
  if (number >= 5041 && number <= 5043) {
    return axis_of(5041);
  }
  return fanuc_modal(number);
}

std::optional<double> SystemVariables::fanuc_modal(std::uint32_t number) const {
  switch (number) {
    case 4001:
      return motion_number(modal_);
    case 4002:
      return plane_number(modal_.plane);
    case 4003:
      return modal_.incremental ? 91 : 90;
    case 4005:
      return feed_mode_number(path().feed_mode());
    case 4006:
      return modal_.inch ? 20 : 21;
    case 4014: {
      constexpr int further = Frames::further_work_offset(0);
      return modal_.work_offset == 0 ? 54 : modal_.work_offset > further ? 54.1 : modal_.work_offset / 10.0;
    }
    case 4109:
      return feed_word();
    case 4120:
      return modal_.selected_tool;
    default:
      return std::nullopt;
  }
}

std::optional<double> SystemVariables::built_in(std::string_view name) const {
  if (!name.starts_with('_')) {
    return std::nullopt;
  }
  const auto flag = [](bool holds) { return holds ? 1.0 : 0.0; };
  const FeedMode mode = path().feed_mode();
  const std::array<std::pair<std::string_view, double>, 22> values{{
      {"_x", position_of(0)},
      {"_y", position_of(1)},
      {"_z", position_of(2)},
      {"_motion_mode", 10 * motion_number(modal_)},
      {"_plane", 10 * plane_number(modal_.plane)},
      {"_metric", flag(!modal_.inch)},
      {"_imperial", flag(modal_.inch)},
      {"_absolute", flag(!modal_.incremental)},
      {"_incremental", flag(modal_.incremental)},
      {"_ijk_absolute_mode", flag(modal_.absolute_centers)},
      {"_inverse_time", flag(mode == FeedMode::inverse_time)},
      {"_units_per_minute", flag(mode == FeedMode::per_minute)},
      {"_units_per_rev", flag(mode == FeedMode::per_revolution)},
      {"_coord_system", modal_.work_offset == 0 ? 540.0 : modal_.work_offset},
      {"_feed", feed_word()},
      {"_selected_tool", modal_.selected_tool},
      {"_current_tool", modal_.tool},
      {"_call_level", static_cast<double>(lines().call_depth())},
      {"_line", static_cast<double>(lines().line())},
      {"_task", 0},
      {"_vmajor", 2.9},
      {"_vminor", 0},
  }};
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == name; });
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

double SystemVariables::numbered(std::uint32_t number, std::uint32_t column) {
  if (const std::optional<double> value = built_in(number)) {
    return *value;
  }
  const double value = variables_.get(number);
  return is_null(value) ? unset(number, column) : value;
}

double SystemVariables::unset(std::uint32_t number, std::uint32_t column) const {
  const bool linuxcnc = is_linuxcnc();
  const bool of_control = linuxcnc ? number > 5000 : number >= first_of_control;
  if (of_control) {
    report(Severity::warning, "control-variable", 0, column, [&] {
      return Text{message(NC_("core", "#{} is a control-internal value"), number),
                  NC_("core", "0 is used; the control may run another path")};
    });
    return 0;
  }
  const bool kept = !variables_.is_local(number) && number > 0 && (linuxcnc || number >= first_kept);
  if (kept) {
    report(Severity::warning, "unset-variable", 0, column, [&] {
      return Text{message(NC_("core", "#{} has not been set by the program"), number),
                  NC_("core", "0 is used; on the control it keeps its last value")};
    });
  }
  return linuxcnc ? 0 : null_value();
}

double SystemVariables::named(const std::string& name, std::uint32_t column) {
  if (const std::optional<double> value = variables_.get(name)) {
    return *value;
  }
  if (const std::optional<double> value = built_in(name)) {
    return *value;
  }
  throw ReadFault{"unset-variable", column, message(NC_("core", "#<{}> has not been set"), name),
                  NC_("core", "the block does not move; set it before, or check how the name is written")};
}

bool SystemVariables::has_name(const std::string& name) const {
  return variables_.get(name) || built_in(name);
}

void SystemVariables::raise_alarm(double number, std::uint32_t column) const {
  report(Severity::error, "alarm", 0, column, [&] {
    return Text{message(NC_("core", "the program raises alarm {}"), number),
                NC_("core", "the control stops here; check the condition that leads to it")};
  });
  lines().end_program();
}

}  // namespace feedscope::iso
