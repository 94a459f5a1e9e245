#include "core/program/sinumerik/geometry/other_axis_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/units.h"
#include "core/program/sinumerik/language/names.h"
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

void OtherAxisWords::go(const std::string& name, const BlockWords::Value& word, bool alone) {
  double& last = places_[name];
  const double value = modal_.is_incremental(word) && !is_orientation(name) ? last + word.value : word.value;
  if (std::exchange(last, value) == value) {
    return;
  }
  const bool cuts = modal_.motion == nullptr || modal_.moves_at_feed();
  const double unit = modal_.inch_feed ? units::from_inch(1) : 1;
  AxisBlock block = turning_alone(path(), unit, !cuts);
  block.alone = alone;
  block.at_tip = oriented_;
  block.great_circle = great_circle_;
  block.way = word.reading == Reading::shortest   ? AxisBlock::Way::shortest
              : word.reading == Reading::positive ? AxisBlock::Way::positive
              : word.reading == Reading::negative ? AxisBlock::Way::negative
                                                  : AxisBlock::Way::written;
  machining_.other_axes.move(is_orientation(name) ? orientation_axis : name, value,
                             !cuts       ? AxisMotion::positions
                             : oriented_ ? AxisMotion::at_tip
                                         : AxisMotion::cuts,
                             word.column, block);
}

bool OtherAxisWords::orient(bool alone) {
  Vec3 direction = Vec3::Zero();
  std::uint32_t column = 0;
  for (const auto& [name, word] : named_) {
    const std::size_t axis = name.size() == 2 && name[1] == '3'
                                 ? std::string_view("ABC").find(letters::to_upper(name[0]))
                                 : std::string_view::npos;
    if (axis != std::string_view::npos) {
      direction[static_cast<Eigen::Index>(axis)] = word.value;
      column = column == 0 ? word.column : column;
    }
  }
  if (column == 0 || !oriented_ || !machining_.other_axes.turns()) {
    return false;
  }
  const std::optional<Vec3> tool =
      machining_.tool_direction(direction, NC_("core", "A3, B3 and C3"), "C3=1", column);
  if (!tool) {
    return true;
  }
  const bool cuts = modal_.motion == nullptr || modal_.moves_at_feed();
  const double unit = modal_.inch_feed ? units::from_inch(1) : 1;
  AxisBlock block = turning_alone(path(), unit, !cuts);
  block.alone = alone;
  block.at_tip = oriented_;
  block.great_circle = great_circle_;
  machining_.other_axes.orient_tool(*tool, cuts ? AxisMotion::at_tip : AxisMotion::positions, column, block);
  return true;
}

void OtherAxisWords::run(bool own) {
  constexpr std::string_view axes = "ABCUVW";
  const bool alone = !words_.has_any("XYZIJKUVW");
  const bool vector = !own && orient(alone);
  for (const auto& [name, value] : named_) {
    if (vector && name.size() == 2 && name[1] == '3') {
      continue;
    }
    go(upper_case(name), value, alone);
  }
  named_.clear();
  if (own || functions_.machine_axes != nullptr || !words_.has_any(axes)) {
    return;
  }
  for (const char letter : axes) {
    if (words_.has(letter)) {
      go(std::string(1, letter), words_[letter], alone);
    }
  }
}

}  // namespace feedscope::sinumerik
