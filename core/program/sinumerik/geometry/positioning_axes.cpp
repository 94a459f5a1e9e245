#include "core/program/sinumerik/geometry/positioning_axes.h"

#include "core/base/units.h"
#include "core/program/sinumerik/geometry/coordinate_value.h"
#include "core/program/sinumerik/language/names.h"

namespace feedscope::sinumerik {

namespace {

/// Reads "[X]".
std::string_view take_index(Scanner& scanner) {
  require(scanner, '[');
  const std::string_view axis = scanner.name();
  require(scanner, ']');
  return axis;
}

}  // namespace

void PositioningAxes::begin_block() {
  if (has_positions_) {
    positions_.fill(std::nullopt);
    has_positions_ = false;
  }
}

bool PositioningAxes::run(std::string_view name, Scanner& scanner) {
  if (letters::same(name, "POS") || letters::same(name, "POSA")) {
    read_position(scanner);
  } else if (letters::same(name, "FA")) {
    read_feed(scanner);
  } else {
    return false;
  }
  return true;
}

/// Reads "[X]=10" after "POS".
void PositioningAxes::read_position(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::string_view name = take_index(scanner);
  require(scanner, '=');
  const BlockWords::Value value = read_coordinate(values_, scanner, column);
  const int axis = linear_axis(name);
  if (axis < 0) {
    machining_.other_axes.move(upper_case(name), value.value, AxisMotion::positions, column);
    return;
  }
  positions_[static_cast<std::size_t>(axis)] = value;
  has_positions_ = true;
}

/// Reads "[X]=1000" after "FA".
void PositioningAxes::read_feed(Scanner& scanner) {
  const int axis = linear_axis(take_index(scanner));
  require(scanner, '=');
  const double feed = values_.read_bounded(scanner);
  if (axis >= 0) {
    const double length = modal_.inch_feed ? units::from_inch(feed) : feed;
    feeds_[static_cast<std::size_t>(axis)] = length > 0 ? units::from_mm_min(length) : 0;
  }
}

/// Each axis goes to its place at its own feed, on its own: a line for one axis. Several are shown as a
/// rapid, and so is one without a feed, whose speed depends on the machine.
void PositioningAxes::move(bool path_moves) {
  splines_.finish();
  Vec3 target = path().position();
  int count = 0;
  std::size_t last = 0;
  std::uint32_t column = 0;
  for (std::size_t axis = 0; axis < positions_.size(); ++axis) {
    if (positions_[axis]) {
      const double value = to_mm(positions_[axis]->value);
      double& coordinate = target[static_cast<int>(axis)];
      coordinate = modal_.is_incremental(*positions_[axis]) ? coordinate + value : value;
      column = column == 0 ? positions_[axis]->column : column;
      last = axis;
      ++count;
    }
  }
  if (path_moves) {
    report(Severity::error, "positioning-axis", 0, column, [] {
      return Text{NC_("core", "positioning axes in a block with a path motion are not supported"),
                  NC_("core", "their motion is skipped; position them in a block of their own")};
    });
    return;
  }
  const double feed = count == 1 ? feeds_[last] : 0;
  if (feed <= 0) {
    report(Severity::info, "positioning-axis", 1, column, [&] {
      return Text{count > 1 ? NC_("core", "positioning axes are shown as a rapid on a straight line")
                            : NC_("core", "a positioning axis is shown as a rapid"),
                  NC_("core", "each axis moves at its own speed, set by FA or the machine")};
    });
  }
  for (std::size_t axis = 0; axis < positions_.size(); ++axis) {
    if (positions_[axis]) {
      targets_.program_axis(static_cast<int>(axis));
    }
  }
  move_to(target, feed, column);
}

/// Moves at `feed` [mm/s], or as a rapid (0).
void PositioningAxes::move_to(const Vec3& target, double feed, std::uint32_t column) {
  last_.set_line();
  last_.set_start(path().position());
  path().set_column(written(column));
  path_modes_.use(feed <= 0);
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

}  // namespace feedscope::sinumerik
