// The part of SinumerikReader that moves positioning axes: POS, POSA, FA.
#include <fmt/format.h>

#include "core/base/units.h"
#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

namespace {

/// "[X]".
std::string_view take_index(Scanner& scanner) {
  require(scanner, '[');
  const std::string_view axis = scanner.name();
  require(scanner, ']');
  return axis;
}

}  // namespace

/// "POS[X]=10", whose name has just been read.
void SinumerikReader::run_pos(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::string_view name = take_index(scanner);
  require(scanner, '=');
  const BlockWords::Value value = coordinate(scanner, column);
  const int axis = linear_axis(name);
  if (axis < 0) {
    note_other_axis(upper_case(name), value.value, AxisMotion::positions, column);
    return;
  }
  positions_[static_cast<std::size_t>(axis)] = value;
  has_positions_ = true;
}

/// "FA[X]=1000".
void SinumerikReader::run_axis_feed(Scanner& scanner) {
  const int axis = linear_axis(take_index(scanner));
  require(scanner, '=');
  const double feed = values_.read_bounded(scanner);
  if (axis >= 0) {
    const double length = modal_.inch_feed ? units::from_inch(feed) : feed;
    modal_.axis_feeds[static_cast<std::size_t>(axis)] = length > 0 ? units::from_mm_min(length) : 0;
  }
}

/// Each goes to its place at its own feed, on its own: that is a line for one axis. Several are shown as a
/// rapid, and so is one without a feed, whose speed is the machine's.
void SinumerikReader::move_positioning_axes() {
  if (!has_positions_) {
    return;
  }
  finish_spline();
  const Vec3 start = path().position();
  Vec3 target = start;
  int count = 0;
  std::size_t last = 0;
  std::uint32_t column = 0;
  for (std::size_t axis = 0; axis < positions_.size(); ++axis) {
    if (positions_[axis]) {
      const double value = to_mm(positions_[axis]->value);
      double& coordinate = target[static_cast<int>(axis)];
      coordinate = is_incremental(*positions_[axis]) ? coordinate + value : value;
      column = column == 0 ? positions_[axis]->column : column;
      last = axis;
      ++count;
    }
  }
  if (has_motion_words()) {
    report(Severity::error, "positioning-axis", 0, column, [] {
      return Text{"positioning axes beside a motion along the path are not read",
                  "their motion is left out; position them in a block of their own"};
    });
    return;
  }
  const double feed = count == 1 ? modal_.axis_feeds[last] : 0;
  if (feed <= 0) {
    report(Severity::info, "positioning-axis", 1, column, [&] {
      return Text{count > 1 ? "axes that position on their own are shown as a rapid on a straight line"
                            : "an axis that positions on its own is shown as a rapid",
                  "each runs at its own speed, which FA or the machine sets"};
    });
  }
  for (std::size_t axis = 0; axis < positions_.size(); ++axis) {
    if (positions_[axis]) {
      program_axis(static_cast<int>(axis));
    }
  }
  last_arc_.reset();
  start_ = start;
  path().set_column(written(column));
  use_path_control(feed <= 0);
  if (feed <= 0) {
    path().rapid(target);
    return;
  }
  const FeedMode mode = path().feed_mode();
  const double path_feed = path().feed();
  path().set_feed_mode(FeedMode::per_minute);
  path().set_feed(feed);
  path().line(target);
  path().set_feed_mode(mode);
  path().set_feed(path_feed);
}

}  // namespace feedscope
