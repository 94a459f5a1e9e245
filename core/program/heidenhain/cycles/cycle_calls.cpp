#include "core/program/heidenhain/cycles/cycle_calls.h"

#include <algorithm>

#include "core/program/path/plane_points.h"

namespace feedscope::heidenhain {

void CycleCalls::call(const MotionWords& words, std::uint32_t column) {
  motions_.run_functions(words);
  cycles_.call(column);
}

void CycleCalls::call_at(const MotionWords& words, std::uint32_t column) {
  cycles_.set_modal(false);
  // Its F applies only to the way there.
  const ContourFeed feed = modal_.feed;
  MotionWords in_plane = words;
  OptionalWord& along = in_plane.axes[static_cast<std::size_t>(normal_axis(plane()))];
  const double raised = along.given ? along.value : 0;
  along.given = false;
  motions_.run(PathKind::line, in_plane);
  modal_.feed = feed;
  cycles_.call(column, raised);
}

void CycleCalls::call_at_pattern(const MotionWords& words, std::uint32_t column) {
  const Cycle& cycle = cycles_.in_force();
  if (pattern_.empty() || cycle.kind == Cycle::Kind::program) {
    report(Severity::error, "cycle-call", 1, column, [&] {
      return Text{pattern_.empty() ? NC_("core", "CYCL CALL PAT without PATTERN DEF")
                                   : NC_("core", "CYCL CALL PAT of a program (cycle 12) is not supported"),
                  NC_("core", "the calls are skipped")};
    });
    return;
  }
  if (cycle.kind == Cycle::Kind::unsupported) {
    return;
  }
  cycles_.set_modal(false);
  const ContourFeed feed = modal_.feed;
  motions_.run_functions(words);
  MotionWords way;
  way.feed_word = words.feed_word == FeedWord::rapid ? FeedWord::rapid : FeedWord::none;
  way.first_column = column;
  const int axis = normal_axis(plane());
  const double start = contour_.position()[axis];
  const auto drilling =
      cycle.kind == Cycle::Kind::drilling ? parameters_.drilling(cycle.number, column) : std::nullopt;
  for (const Vec3& place : pattern_) {
    MotionWords up = way;
    up.feed_word = FeedWord::rapid;
    Vec3 target = contour_.position();
    const double safe = drilling ? drilling->surface + place[axis] + drilling->second_clearance : start;
    target[axis] = std::max(start, safe);
    if (target[axis] > contour_.position()[axis]) {
      contour_.add(targets_.element(up, target));
    }
    ContourElement element = targets_.element(way, from_plane(in_plane(place, plane()), plane(), target));
    element.place.axes = 7;
    contour_.add(element);
    cycles_.call(column, place[axis]);
  }
  modal_.feed = feed;
}

}  // namespace feedscope::heidenhain
