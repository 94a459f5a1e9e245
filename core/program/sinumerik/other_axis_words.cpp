#include "core/program/sinumerik/other_axis_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/program/sinumerik/names.h"
#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

bool OtherAxisWords::is_orientation(std::string_view name) {
  constexpr auto names = std::to_array<std::string_view>({"LEAD", "TILT", "THETA", "PHI", "PSI", "NUT"});
  const bool component = name.size() == 2 &&
                         std::string_view("ABC").find(letters::to_upper(name[0])) != std::string_view::npos &&
                         name[1] >= '2' && name[1] <= '7';
  return component || std::any_of(names.begin(), names.end(),
                                  [&](std::string_view known) { return letters::same(known, name); });
}

void OtherAxisWords::move(std::string_view name, std::uint32_t column, double value) {
  double& last = places_[upper_case(name)];
  if (std::exchange(last, value) == value) {
    return;
  }
  const bool cuts = modal_.motion == nullptr || modal_.moves_at_feed();
  machining_.other_axes.move(is_orientation(name) ? "tool orientation" : upper_case(name), value,
                             !cuts       ? AxisMotion::positions
                             : oriented_ ? AxisMotion::at_tip
                                         : AxisMotion::cuts,
                             column);
}

void OtherAxisWords::run() {
  constexpr std::string_view axes = "ABCUVW";
  if (functions_.machine_axes != nullptr || !words_.has_any(axes)) {
    return;
  }
  for (const char letter : axes) {
    if (words_.has(letter)) {
      move(std::string_view(&letter, 1), words_[letter].column, words_[letter].value);
    }
  }
}

}  // namespace feedscope::sinumerik
