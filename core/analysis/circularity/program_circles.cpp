#include "core/analysis/circularity/program_circles.h"

#include <algorithm>

namespace feedscope {
namespace {

/// First element in [0, size) for which `is_before(element)` is false.
template <class Condition>
std::size_t first_not(std::size_t size, Condition is_before) {
  std::size_t low = 0;
  std::size_t high = size;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    (is_before(middle) ? low : high) = is_before(middle) ? middle + 1 : middle;
  }
  return low;
}

/// Start of an element: the last instant at its start, after any pauses before it [s].
double begin_of(const Trajectory& trajectory, std::size_t element) {
  if (element >= trajectory.path().size()) {
    return trajectory.duration();
  }
  const std::size_t piece = first_not(trajectory.pieces().size(),
                                      [&](std::size_t i) { return trajectory.last_element(i) < element; });
  if (piece >= trajectory.pieces().size()) {
    return trajectory.duration();
  }
  const Piece& found = trajectory.pieces()[piece];
  return found.element >= element ? found.time : trajectory.state_at_path(trajectory.path().s(element)).time;
}

Bracket time_on(const Trajectory& trajectory, const FullCircle& circle) {
  const BlendedPath& path = trajectory.path();
  const auto element_from = [&](std::size_t segment) {
    return first_not(path.size(), [&](std::size_t i) { return path.segment(i) < segment; });
  };
  std::size_t end = element_from(circle.last + 1);
  while (end > 0 && path.in_corner(end - 1) && path.segment(end - 1) == circle.last) {
    --end;
  }
  return {begin_of(trajectory, element_from(circle.first)), begin_of(trajectory, end)};
}

/// Pass about the centre of the test, which both of its circles share up to rounding.
CirclePass pass_of(const Run& run, const FullCircle& circle, const CircularTest& test) {
  CirclePass pass =
      pass_between(run, time_on(*run.trajectory, circle), {circle.plane, test.center, test.request.radius});
  pass.counter_clockwise = circle.counter_clockwise;
  pass.start = circle.start;
  pass.first_line = circle.first_line;
  pass.last_line = circle.last_line;
  return pass;
}

CircularTest test_of(const FullCircle& circle, bool actual) {
  CircularTest test;
  test.request = {circle.radius, circle.feed, circle.plane, circle.start, circle.sweep, 0};
  test.center = circle.center;
  test.actual = actual;
  return test;
}

}  // namespace

ProgramCircles program_circles(const Run& run, Progress* progress) {
  const FullCircles found = find_full_circles(*run.path);
  ProgramCircles result;
  result.found = found.circles.size();
  result.evaluated = std::min(found.circles.size(), max_program_circles);
  result.helices = found.helices;
  result.tilted = found.tilted;
  result.actual = run.sources.actual != nullptr;
  std::vector<const FullCircle*> of_test;  // first circle of each test
  for (std::size_t i = 0; i < result.evaluated; ++i) {
    if (progress != nullptr) {
      progress->report(static_cast<double>(i) / static_cast<double>(result.evaluated));
    }
    const FullCircle& circle = found.circles[i];
    std::size_t test = 0;
    while (test < of_test.size() &&
           !(result.tests[test].passes.size() == 1 && is_same_circle(*of_test[test], circle) &&
             of_test[test]->counter_clockwise != circle.counter_clockwise)) {
      ++test;
    }
    if (test == of_test.size()) {
      of_test.push_back(&circle);
      result.tests.push_back(test_of(circle, result.actual));
    }
    result.tests[test].passes.push_back(pass_of(run, circle, result.tests[test]));
    result.tests[test].join();
  }
  return result;
}

std::vector<Message> program_circle_notes(const ProgramCircles& circles) {
  std::vector<Message> notes;
  if (circles.found == 0) {
    notes.push_back(NC_("core",
                        "The program has no full circle: no cut runs a whole turn in XY, ZX or YZ by arcs "
                        "about one centre. Circles of short lines are not recognised."));
  }
  if (circles.evaluated < circles.found) {
    notes.push_back(message(NC_("core", "The program has {} full circles; the first {} are evaluated."),
                            circles.found, circles.evaluated));
  }
  if (circles.helices > 0) {
    notes.push_back(circles.helices == 1 ? NC_("core", "Not evaluated: 1 helix with full turns.")
                                         : message(NC_("core", "Not evaluated: {} helices with full turns."),
                                                   circles.helices));
  }
  if (circles.tilted > 0) {
    notes.push_back(
        circles.tilted == 1
            ? NC_("core", "Not evaluated: 1 full circle outside the planes XY, ZX and YZ.")
            : message(NC_("core", "Not evaluated: {} full circles outside the planes XY, ZX and YZ."),
                      circles.tilted));
  }
  return notes;
}

}  // namespace feedscope
