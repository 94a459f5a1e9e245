#include "core/program/path/other_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace feedscope {

void OtherAxes::move(std::string_view axis, double target, AxisMotion motion, std::uint32_t column) {
  auto known =
      std::find_if(axes_.begin(), axes_.end(), [&](const Axis& other) { return other.name == axis; });
  if (known == axes_.end()) {
    program_.other_axes.emplace_back(axis);
    known = axes_.insert(known, {std::string(axis), {}});
  }
  if (std::exchange(known->reported[static_cast<std::size_t>(motion)], true)) {
    return;
  }
  const Severity severity = motion == AxisMotion::cuts ? Severity::error : Severity::warning;
  const std::string_view path = motion == AxisMotion::at_tip
                                    ? "X, Y and Z are those of the tool's tip and shown as programmed"
                                    : "X, Y and Z are shown as programmed";
  const int kind = static_cast<int>(motion) + 3 * static_cast<int>(known - axes_.begin());
  log_.add(severity, "unread-axis", kind, lines_.place(column), [&] {
    return DiagnosticLog::Text{
        fmt::format("{}{} moves to {}{}, which is not simulated",
                    axis.find(' ') == std::string_view::npos ? "axis " : "", axis, target,
                    motion == AxisMotion::positions ? "" : " in a feed move"),
        fmt::format(
            "{}; the time of this axis is not included, so the cycle time is too short; reported once",
            path)};
  });
}

}  // namespace feedscope
