#include "core/analysis/agreement/agreement.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/agreement/held_stretches.h"
#include "core/analysis/agreement/trace_likeness.h"
#include "core/analysis/study/operations.h"
#include "core/base/error.h"
#include "core/trajectory/state_walk.h"

namespace feedscope {
namespace {

constexpr std::size_t most_worst = 10;

/// Stretch from the later beginning to the earlier end of the two motions, so that both are measured over the
/// same path.
struct Compared {
  double from = 0;  ///< [mm]
  double to = 0;
};

Compared compared_part(const TraceOnProgram& trace, const TimeLaw& simulated, double margin) {
  return {std::max(trace.law.first_s(), simulated.first_s()) + margin,
          std::min(trace.law.last_s(), simulated.last_s()) - margin};
}

/// Time of a run from rest to `part.from` and from `part.to` to rest [s].
double ends_of(const Trajectory& trajectory, const TimeLaw& simulated, const Compared& part, double step) {
  double first = 0;
  double last = trajectory.duration();
  StateWalk walk(trajectory);
  for (double t = 0; t < trajectory.duration() && walk.at_without_length(t).speed <= 0; t += step) {
    first = t;
  }
  for (double t = last; t > 0 && trajectory.state(t).speed <= 0; t -= step) {
    last = t;
  }
  return std::max(0.0, simulated.at(part.from) - first) + std::max(0.0, last - simulated.at(part.to));
}

void add_operations(const Run& run, const ProgrammedCourse& course, const TimeLaw& measured,
                    const TimeLaw& simulated, const Compared& part, Agreement& found) {
  std::vector<Operation> operations;
  for (const OperationSplit split : {OperationSplit::tool, OperationSplit::comment}) {
    if (operations.size() < 2) {
      operations = split_operations(*run.input.program, *run.path, split);
      found.split = split;
    }
  }
  if (operations.size() < 2) {
    return;
  }
  for (const Operation& operation : operations) {
    const double from = std::clamp(course.start_of(operation.first), part.from, part.to);
    const double to = std::clamp(course.start_of(operation.last), part.from, part.to);
    if (to > from) {
      found.operations.push_back({operation.title, operation.line, measured.at(to) - measured.at(from),
                                  simulated.at(to) - simulated.at(from)});
    }
  }
}

Vec3 place_at(const ProgrammedCourse& course, double s) {
  std::size_t low = 0;
  std::size_t high = course.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (course.s(middle) <= s ? low : high) = middle;
  }
  const double length = course.s(high) - course.s(low);
  const double share = length > 0 ? std::clamp((s - course.s(low)) / length, 0.0, 1.0) : 0;
  return course.point(low) + share * (course.point(high) - course.point(low));
}

std::vector<WorstPlace> worst_of(const std::vector<AgreementCell>& cells, const ProgrammedCourse& course,
                                 const Toolpath& toolpath) {
  constexpr std::ptrdiff_t apart = 4;  // cells
  std::vector<std::size_t> order(cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  const auto off = [&](std::size_t i) { return std::abs(cells[i].measured_time - cells[i].simulated_time); };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return off(a) > off(b); });
  std::vector<WorstPlace> worst;
  std::vector<std::size_t> taken;
  for (const std::size_t i : order) {
    if (worst.size() == most_worst || off(i) <= 0) {
      break;
    }
    if (std::ranges::any_of(taken, [&](std::size_t other) {
          return std::abs(static_cast<std::ptrdiff_t>(other) - static_cast<std::ptrdiff_t>(i)) < apart;
        })) {
      continue;
    }
    taken.push_back(i);
    const AgreementCell& cell = cells[i];
    const double middle = cell.s + cell.length / 2;
    worst.push_back({toolpath.segments[course.segment_at(middle)].line, middle, place_at(course, middle),
                     cell.measured_feed(), cell.simulated_feed(), cell.measured_time - cell.simulated_time});
  }
  return worst;
}

/// Whether the trace reaches both ends of the path as far as its axes show it: even a program recorded to
/// within a millimetre of its end still slows down there.
bool reaches_ends(const TraceOnProgram& trace, const ProgrammedCourse& course, double margin) {
  constexpr double nearly = 10;  // margins
  std::size_t first = 0;
  std::size_t last = course.size() - 1;
  while (first < last && course.seen_length(first + 1) == course.seen_length(0)) {
    ++first;
  }
  while (last > first && course.seen_length(last - 1) == course.seen_length(course.size() - 1)) {
    --last;
  }
  return trace.law.first_s() <= course.s(first) + nearly * margin &&
         trace.law.last_s() >= course.s(last) - nearly * margin;
}

}  // namespace

double Agreement::corner_rms() const {
  double squares = 0;
  for (const CornerAgreement& corner : corners) {
    squares += corner.error() * corner.error();
  }
  return corners.empty() ? 0 : std::sqrt(squares / static_cast<double>(corners.size()));
}

MotionRecord record_of(const Trajectory& trajectory, double step, const Progress* progress) {
  constexpr std::size_t between_looks = 1024;
  MotionRecord record;
  StateWalk walk(trajectory);
  const auto count = static_cast<std::size_t>(std::ceil(trajectory.duration() / step));
  record.time.reserve(count + 1);
  record.place.reserve(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    if (i % between_looks == 0) {
      stop_if_cancelled(progress);
    }
    const double time = std::min(static_cast<double>(i) * step, trajectory.duration());
    record.time.push_back(time);
    record.place.push_back(walk.at_without_length(time).position);
  }
  return record;
}

double deviation_of(const Trajectory& trajectory, const ProgrammedCourse& course, double step,
                    Progress* progress) {
  const MotionRecord record = record_of(trajectory, step, progress);
  const double widest = (course.bounds().max - course.bounds().min).norm() / 4 + usual_deviation;
  // Use the smallest tolerance that suffices: a wide one lets the matching take shortcuts.
  MatchedRecord matched;
  for (double tolerance = usual_deviation; tolerance <= widest; tolerance *= 2) {
    matched = match_record(course, record, {tolerance, 0}, 0, progress);
    if (!matched.empty() && matched.lost == 0) {
      break;
    }
  }
  float largest = 0;
  for (std::size_t i = matched.first; i < matched.end; ++i) {
    largest = std::isnan(matched.s[i]) ? largest : std::max(largest, matched.distance[i]);
  }
  return static_cast<double>(largest);
}

std::vector<double> cell_borders(const TimeLaw& law, double least_time, double least_length) {
  constexpr double shortest_pause = 0.05;   // [s]
  constexpr double least_clearance = 0.01;  // [mm]
  const double clearance = std::max(least_clearance, 2 * least_length);
  std::vector<double> pauses;
  for (std::size_t i = 1; i < law.places().size(); ++i) {
    if (law.places()[i] == law.places()[i - 1] &&
        law.times()[i] - law.times()[i - 1] >= std::min(least_time, shortest_pause)) {
      pauses.push_back(law.places()[i]);
    }
  }
  std::vector<double> borders;
  double time = 0;
  std::size_t pause = 0;
  for (std::size_t i = 0; i < law.places().size(); ++i) {
    while (pause < pauses.size() && pauses[pause] < law.places()[i] - clearance) {
      ++pause;
    }
    if (pause < pauses.size() && pauses[pause] <= law.places()[i] + clearance) {
      continue;
    }
    if (borders.empty() ||
        (law.places()[i] - borders.back() >= least_length && law.times()[i] - time >= least_time)) {
      borders.push_back(law.places()[i]);
      time = law.times()[i];
    }
  }
  return borders;
}

Agreement agreement_of(const TraceOnProgram& trace, const ProgrammedCourse& course, const Run& run,
                       Progress* progress) {
  constexpr double samples_a_cell = 5;
  constexpr double cells_a_trace = 5000;
  constexpr double finest_step = 5e-4;  // [s]
  if (trace.law.empty()) {
    const auto likeness = std::ranges::find_if(trace.remarks, says_likeness);
    if (likeness != trace.remarks.end()) {
      throw InputError(message(NC_("core", "as it is, the trace is nowhere on this program: {}; {}"),
                               likeness->message, likeness->hint));
    }
    throw InputError(message(NC_("core",
                                 "the trace is nowhere within {:.3g} mm of the path of the program; it is of "
                                 "another program, or its zero point is another"),
                             trace.tolerance));
  }
  const double period =
      trace.record.time.back() / static_cast<double>(std::max<std::size_t>(1, trace.record.time.size() - 1));
  const double step = std::max(finest_step, std::min(period, run.trajectory->duration() / 1000));
  const MotionRecord simulated_record = record_of(*run.trajectory, step, progress);
  const MatchedRecord simulated_match =
      match_record(course, simulated_record, {trace.tolerance, trace.noise}, 0, progress);
  const TimeLaw simulated(simulated_record.time, simulated_match);
  if (simulated.empty()) {
    throw InputError(NC_(
        "core", "the run does not follow the path of the program within the tolerance of the comparison"));
  }
  const double margin = std::max(begun_motion, 4 * trace.noise);
  const Compared part = compared_part(trace, simulated, margin);
  if (!(part.to > part.from)) {
    throw InputError(NC_("core", "trace and run have no part of the path in common"));
  }
  Agreement agreement;
  agreement.rate = trace.rate;
  agreement.whole = !trace.pass_times.empty() && trace.belongs() && reaches_ends(trace, course, margin);
  agreement.measured_time = trace.law.at(part.to) - trace.law.at(part.from);
  agreement.simulated_time = simulated.at(part.to) - simulated.at(part.from);
  if (agreement.whole) {
    // The trace lacks more than the margins at its ends, or motions of axes that it does not record.
    constexpr double short_end = 0.1;  // [s]
    const double ends = ends_of(*run.trajectory, simulated, part, step);
    bool lacks_motion = false;
    for (std::size_t axis = 0; axis < course.seen().size(); ++axis) {
      lacks_motion = lacks_motion || (course.moves(axis) && !course.seen()[axis]);
    }
    agreement.whole = ends < short_end || !lacks_motion;
    if (agreement.whole) {
      agreement.measured_time += ends;
      agreement.simulated_time += ends;
    }
  }
  agreement.distance = trace.largest_distance;
  agreement.simulated_distance =
      simulated.distance(std::min(part.from, part.to), std::max(part.from, part.to));
  const std::vector<HeldStretch> held = held_stretches(trace.law, simulated, trace.noise);
  for (const HeldStretch& one : held) {
    agreement.held_time += one.to_s > part.from && one.from_s < part.to ? one.held : 0;
  }
  const auto is_held = [&](double from_s, double to_s) {
    return std::ranges::any_of(
        held, [&](const HeldStretch& one) { return one.from_s < to_s && one.to_s > from_s; });
  };
  std::vector<double> borders =
      cell_borders(trace.law, std::max(samples_a_cell * period, agreement.measured_time / cells_a_trace),
                   std::max(begun_motion, 20 * trace.noise));
  std::erase_if(borders, [&](double s) { return s < part.from || s > part.to; });
  double squares = 0;
  double length = 0;
  for (std::size_t i = 1; i < borders.size(); ++i) {
    if (trace.loses(borders[i - 1], borders[i]) || is_held(borders[i - 1], borders[i])) {
      continue;
    }
    const AgreementCell cell{borders[i - 1], borders[i] - borders[i - 1],
                             trace.law.at(borders[i]) - trace.law.at(borders[i - 1]),
                             simulated.at(borders[i]) - simulated.at(borders[i - 1])};
    agreement.cells.push_back(cell);
    if (cell.measured_time > 0 && cell.simulated_time > 0) {
      const double off = cell.measured_feed() - cell.simulated_feed();
      squares += cell.length * off * off;
      length += cell.length;
    }
  }
  agreement.feed_rms = length > 0 ? std::sqrt(squares / length) : 0;
  agreement.worst = worst_of(agreement.cells, course, *run.path);
  add_operations(run, course, trace.law, simulated, part, agreement);
  constexpr double clear_of_noise = 20;
  agreement.corners = corners_of(*run.path, course, trace.law, simulated, part.from, part.to,
                                 std::max(begun_motion, clear_of_noise * trace.noise));
  std::erase_if(agreement.corners, [&](const CornerAgreement& corner) {
    return is_held(corner.s - corner.reach, corner.s + corner.reach);
  });
  agreement.simulated = simulated;
  agreement.margin = margin;
  return agreement;
}

}  // namespace feedscope
