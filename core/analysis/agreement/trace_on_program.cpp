#include "core/analysis/agreement/trace_on_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/agreement/block_numbers.h"
#include "core/analysis/agreement/line_guide.h"

namespace feedscope {
namespace {

constexpr double half = 0.5;
constexpr double whole = 0.99;
constexpr double begun_jump = 1;    // [mm]
constexpr double gap_share = 1.75;  // of the period: a sample is missing

/// A trace placed on the path in one way.
struct Placement {
  TracePose pose;
  MatchedRecord matched;
  TraceFit fit;
};

MotionRecord posed(const TracePose& pose, MotionRecord record) {
  for (Vec3& place : record.place) {
    place = pose.apply(place);
  }
  return record;
}

Placement placed_by(const TracePose& pose, const ProgrammedCourse& course, const MotionRecord& record,
                    const MatchOptions& options, double period, Progress* progress,
                    const LineGuide* guide = nullptr) {
  constexpr double surely = 0.9;
  Placement best;
  for (const bool anywhere : {false, true}) {  // part of a program may pass its start later
    Placement placement;
    placement.pose = pose;
    placement.matched = match_record(course, record, options, {guide, anywhere}, 0, progress);
    placement.fit = fit_of(course, record, placement.matched, options, period);
    if (!anywhere || placement.fit.trace_share > best.fit.trace_share) {
      best = std::move(placement);
    }
    if (best.fit.trace_share >= surely || best.fit.path_share >= surely) {
      break;
    }
  }
  return best;
}

/// Part of a record that suffices to see where it fits: samples `step` apart [mm], at most `most`.
MotionRecord thinned(const ProgrammedCourse& course, const MotionRecord& record, double step,
                     std::size_t most) {
  MotionRecord kept;
  for (std::size_t i = 0; i < record.place.size() && kept.place.size() < most; ++i) {
    if (kept.place.empty() || course.visible(record.place[i] - kept.place.back()).norm() >= step) {
      kept.time.push_back(record.time[i]);
      kept.place.push_back(record.place[i]);
    }
  }
  return kept;
}

/// Whether a record is one straight line, which fits wherever there is a line.
bool is_straight(const ProgrammedCourse& course, const MotionRecord& record) {
  constexpr double detour = 1.2;
  double way = 0;
  Bounds bounds;
  for (std::size_t i = 0; i < record.place.size(); ++i) {
    bounds.add(course.visible(record.place[i]));
    way += i > 0 ? (course.visible(record.place[i]) - course.visible(record.place[i - 1])).norm() : 0;
  }
  return way < detour * (bounds.max - bounds.min).norm();
}

/// Unit, signs and zero point of a trace of a part of the program, whose extent gives no information: the
/// simplest with which nearly all of it fits. `own`: in its own coordinates; returned if no other fits.
TracePose pose_of_a_part(const ProgrammedCourse& course, const MotionRecord& record,
                         const MatchOptions& options, const Placement& own) {
  constexpr double right = 0.9;
  constexpr double clearly = 0.05;
  constexpr std::size_t least_samples = 50;  // a tolerance apart
  constexpr std::size_t most_samples = 10'000;
  constexpr double most_searched = 2e6;  // points during each search for the start
  constexpr double inch = 25.4;
  const SeenAxes& seen = course.seen();
  const Vec3 extent = course.bounds().max - course.bounds().min;
  MatchOptions quick = options;
  quick.most_searched = most_searched;
  constexpr double no_gaps = std::numeric_limits<double>::infinity();
  TracePose best = own.pose;
  if (std::ranges::count(seen, true) < 2) {
    return best;
  }
  double best_share = std::max(right, own.fit.trace_share) - clearly;
  enum class Anchor { zero, start, end };
  for (const Anchor anchor : {Anchor::zero, Anchor::start, Anchor::end}) {
    for (const double scale : {1.0, inch, 1 / inch}) {
      const MotionRecord few = thinned(course, record, options.tolerance / scale, most_samples);
      if (few.place.size() < least_samples || is_straight(course, few)) {
        continue;
      }
      for (int signs = 0; signs < 8; ++signs) {
        TracePose pose;
        pose.scale = scale;
        bool moves = true;
        for (int axis = 0; axis < 3; ++axis) {
          const bool mirrored = (signs >> axis & 1) != 0;
          pose.mirror[axis] = mirrored ? -1 : 1;
          moves = moves &&
                  (!mirrored || (seen[static_cast<std::size_t>(axis)] && extent[axis] > options.tolerance));
        }
        if (!moves) {
          continue;
        }
        const auto shift = [&](const Vec3& recorded, const Vec3& there) {
          pose.offset = there - course.visible(pose.apply(recorded));
        };
        if (anchor == Anchor::start) {
          shift(few.place.front(), course.point(0));
        } else if (anchor == Anchor::end) {
          shift(few.place.back(), course.point(course.size() - 1));
        }
        const Placement placement = placed_by(pose, course, posed(pose, few), quick, no_gaps, nullptr);
        if (placement.fit.trace_share > best_share + clearly) {
          best = pose;
          best_share = placement.fit.trace_share;
        }
      }
    }
  }
  return best;
}

/// Median distance of the matched samples from the path [mm].
double usual_distance(const MatchedRecord& matched) {
  std::vector<float> distances;
  for (std::size_t i = matched.first; i < matched.end; ++i) {
    if (!std::isnan(matched.s[i])) {
      distances.push_back(matched.distance[i]);
    }
  }
  if (distances.empty()) {
    return 0;
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::ranges::nth_element(distances, middle);
  return static_cast<double>(*middle);
}

std::vector<LostStretch> lost_of(const MotionRecord& record, const MatchedRecord& matched, double period) {
  std::vector<LostStretch> lost;
  std::size_t last = matched.first;
  for (std::size_t i = matched.first + 1; i < matched.end; ++i) {
    if (std::isnan(matched.s[i])) {
      continue;
    }
    const bool off = i - last > 2;
    const double time = record.time[i] - record.time[last];
    const bool jumps =
        !off && (record.place[i] - record.place[last]).norm() > fastest_possible * time + begun_jump;
    if (off || jumps || time > 2 * gap_share * period) {
      lost.push_back({record.time[last], record.time[i], matched.s[last], matched.s[i], off, jumps});
    }
    last = i;
  }
  return lost;
}

}  // namespace

bool TraceOnProgram::belongs() const {
  return fit.trace_share >= half || fit.path_share >= half;
}

bool TraceOnProgram::loses(double from_s, double to_s, bool recorded_alone) const {
  auto stretch = std::ranges::lower_bound(lost, from_s, {}, &LostStretch::to_s);
  for (; stretch != lost.end() && stretch->from_s <= to_s; ++stretch) {
    if (stretch->recorded || !recorded_alone) {
      return true;
    }
  }
  return false;
}

MotionRecord record_of(const Trace& trace) {
  MotionRecord record;
  record.time = trace.time;
  record.place.reserve(trace.size());
  for (std::size_t i = 0; i < trace.size(); ++i) {
    record.place.push_back(trace.place_at(i));
  }
  return record;
}

TraceOnProgram find_on_program(const Trace& trace, const ProgrammedCourse& course, double deviation,
                               const SourceText* source, Progress* progress) {
  constexpr double surely = 0.9;
  TraceOnProgram found;
  found.rate = trace.rate();
  const MotionRecord recorded = record_of(trace);
  const double noise = noise_of(recorded);
  const auto options_at = [&](const TracePose& pose) {
    return MatchOptions{usual_deviation + 2 * deviation + 6 * pose.scale * noise, pose.scale * noise};
  };
  const LineGuide lines(course, trace.line, trace.time);
  const std::vector<std::uint32_t> numbered_lines = source != nullptr && !trace.line.empty()
                                                        ? BlockNumbers(*source).lines_of(trace.line)
                                                        : std::vector<std::uint32_t>();
  const LineGuide numbers(course, numbered_lines, trace.time);
  std::vector<const LineGuide*> guides;  // the first one is in use
  for (const LineGuide* one : {&lines, &numbers}) {
    if (one->usable()) {
      guides.push_back(one);
    }
  }
  guides.push_back(nullptr);  // position alone
  const auto place = [&](const TracePose& pose) {
    found.record = posed(pose, recorded);
    const auto placed_with = [&](const LineGuide* guide) {
      return placed_by(pose, course, found.record, options_at(pose), trace.period, progress, guide);
    };
    Placement placed = placed_with(guides.front());
    while (guides.size() > 1 && placed.fit.trace_share < surely) {
      Placement other = placed_with(guides[1]);
      if (other.fit.trace_share <= placed.fit.trace_share + (1 - surely)) {
        break;
      }
      guides.erase(guides.begin());  // lines of another program
      placed = std::move(other);
    }
    return placed;
  };
  Placement placement = place(TracePose());
  if (placement.fit.trace_share < surely || placement.fit.path_share < surely) {
    const TracePose pose = find_pose(course, recorded);
    if (!pose.plain() || !pose.offset.isZero()) {
      Placement moved = place(pose);
      // Otherwise its extent agrees with that of the program by chance.
      placement = moved.fit.trace_share >= half ? std::move(moved) : place(TracePose());
    }
  }
  if (placement.fit.trace_share < surely && placement.fit.path_share < surely) {
    const TracePose pose = pose_of_a_part(course, recorded, options_at(TracePose()), placement);
    if (pose.scale != placement.pose.scale || pose.mirror != placement.pose.mirror ||
        pose.offset != placement.pose.offset) {
      placement = place(pose);
    }
  }
  const MatchOptions options = options_at(placement.pose);
  if (!placement.matched.empty() && placement.fit.trace_share >= half) {
    const Vec3 left = offset_left(course, found.record, placement.matched, options.noise);
    if (left.norm() > 0) {
      TracePose nearer = placement.pose;
      nearer.offset -= left;
      Placement moved = place(nearer);
      // Corners cut on one side only are no offset: with the right offset most of the trace is on the path.
      if (moved.fit.trace_share < placement.fit.trace_share - (1 - whole) ||
          usual_distance(moved.matched) > half * usual_distance(placement.matched)) {
        moved = place(placement.pose);
      }
      placement = std::move(moved);
    }
  }
  found.pose = placement.pose;
  found.matched = std::move(placement.matched);
  found.fit = placement.fit;
  found.noise = options.noise;
  found.tolerance = options.tolerance;
  if (!found.matched.empty()) {
    found.law = TimeLaw(found.record.time, found.matched);
    found.lost = lost_of(found.record, found.matched, trace.period);
    // Samples after the end, such as another pass, are not compared.
    const std::size_t end = std::min(found.matched.end, found.matched.arrival + 1);
    for (std::size_t i = found.matched.first; i < end; ++i) {
      if (!std::isnan(found.matched.s[i])) {
        found.largest_distance =
            std::max(found.largest_distance, static_cast<double>(found.matched.distance[i]));
      }
    }
  }
  if (!found.law.empty() && course.length() > 0) {
    double covered = found.law.last_s() - found.law.first_s();
    for (const LostStretch& stretch : found.lost) {
      covered -= stretch.to_s - stretch.from_s;
    }
    found.share = covered / course.length();
  }
  MatchedRecord pass = found.matched;
  while (!pass.empty() && found.belongs()) {
    const TimeLaw law(found.record.time, pass);
    if (law.empty() || law.last_s() - law.first_s() < whole * course.length()) {
      break;
    }
    const double margin = std::max(begun_motion, 4 * found.noise);
    found.pass_times.push_back(law.at(law.last_s() - margin) - law.at(law.first_s() + margin));
    if (pass.arrival + 1 >= found.record.place.size()) {
      break;
    }
    pass = match_record(course, found.record, options, {guides.front()}, pass.arrival, progress);
  }
  found.remarks = remarks_on(found, trace, course);
  if (!trace.line.empty() && guides.front() == nullptr && found.belongs()) {
    found.remarks.push_back(
        {.severity = Severity::info,
         .line = 0,
         .column = 0,
         .code = "trace-lines",
         .message = NC_(
             "core",
             "the program lines of the trace are not those of this program; it is matched by position alone"),
         .hint = NC_("core", "record the line of the file, or number its blocks")});
  }
  return found;
}

}  // namespace feedscope
