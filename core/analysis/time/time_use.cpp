#include "core/analysis/time/time_use.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/analysis/time/programmed_time.h"
#include "core/base/exact_sum.h"
#include "core/base/translatable.h"
#include "core/limits/axis_share.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

constexpr std::size_t most_by_comment = 200;  // more headings are remarks, not operations

constexpr double same_length = 1e-9;  // of the path: up to this, two lengths are equal

struct KindText {
  std::string_view key;
  std::string_view title;
};
/// In the order of TimeKind.
constexpr std::array<KindText, time_kind_count> kind_texts{{
    {"cutting", QT_TRANSLATE_NOOP("core", "feed motions")},
    {"rapid", QT_TRANSLATE_NOOP("core", "rapids")},
    {"dwell", QT_TRANSLATE_NOOP("core", "dwells")},
    {"tool_change", QT_TRANSLATE_NOOP("core", "tool changes")},
    {"spindle_start", QT_TRANSLATE_NOOP("core", "spindle starts")},
    {"indexing", QT_TRANSLATE_NOOP("core", "indexing of rotary axes")},
}};

TimeKind kind_of_pause(Pause pause) {
  switch (pause) {
    case Pause::tool_change:
      return TimeKind::tool_change;
    case Pause::spindle_start:
      return TimeKind::spindle_start;
    case Pause::indexing:
    case Pause::swing:
      return TimeKind::indexing;
    default:
      return TimeKind::dwell;
  }
}

/// Executed length of a part [mm].
double length_of(const Trajectory& trajectory, PartWalk& walk) {
  const Part& part = walk.part();
  const BlendedPath& path = trajectory.path();
  switch (part.law) {
    case Law::filtered:
      return trajectory.filtered_length(part);
    case Law::parameter: {
      constexpr double all_of_it = 1 - 1e-12;
      if (part.q == 0 && law_at(part, part.duration).q >= all_of_it) {
        return path.length(part.element);
      }
      const PartMotion motion = walk.motion();
      return motion.state(part.duration).path_length - motion.state(0).path_length;
    }
    default:
      return law_at(part, part.duration).q - part.q;
  }
}

/// Sums of one operation, or of the whole run, by cause.
struct CauseSums {
  std::vector<ExactSum> time = std::vector<ExactSum>(all_causes().size());
  std::vector<ExactSum> lost = std::vector<ExactSum>(all_causes().size());

  void add(std::size_t cause, double seconds, double loss) {
    time[cause].add(seconds);
    lost[cause].add(loss);
  }
  CauseCost cost(std::size_t i) const { return {all_causes()[i], time[i].value(), lost[i].value()}; }
};

/// Operations, those with equal headings merged, and the operation of every segment.
struct Sections {
  OperationSplit split = OperationSplit::none;
  std::vector<OperationTime> operations;
  std::vector<std::pair<std::uint32_t, std::size_t>> starts;  ///< first segment, index into `operations`
};

Sections sections_of(const Run& run, OperationSplit split) {
  Sections sections;
  sections.split = split;
  std::map<std::pair<std::uint32_t, std::string>, std::size_t> known;
  for (Operation& operation : split_operations(*run.input.program, *run.path, split)) {
    const auto [found, is_new] =
        known.try_emplace({operation.line, operation.title}, sections.operations.size());
    if (is_new) {
      OperationTime time;
      time.title = std::move(operation.title);
      time.line = operation.line;
      time.start = std::numeric_limits<double>::infinity();
      sections.operations.push_back(std::move(time));
    }
    sections.starts.emplace_back(operation.first, found->second);
  }
  return sections;
}

Sections usual_sections(const Run& run, OperationSplit split) {
  if (split != OperationSplit::none) {
    return sections_of(run, split);
  }
  Sections by_tool = sections_of(run, OperationSplit::tool);
  const auto tools = std::ranges::count_if(by_tool.operations, [](const OperationTime& operation) {
    return operation.title != before_first_tool;
  });
  if (tools > 1) {
    return by_tool;
  }
  Sections by_comment = sections_of(run, OperationSplit::comment);
  const std::size_t count = by_comment.operations.size();
  return count > 1 && count <= most_by_comment ? by_comment : Sections();
}

/// Walks over sections for segments in ascending order.
class SectionWalk {
 public:
  explicit SectionWalk(const Sections& sections) : starts_(sections.starts) {}
  /// Index of the section of `segment`; none without sections.
  std::optional<std::size_t> at(std::uint32_t segment) {
    while (next_ < starts_.size() && starts_[next_].first <= segment) {
      ++next_;
    }
    return next_ > 0 ? std::optional(starts_[next_ - 1].second) : std::nullopt;
  }

 private:
  const std::vector<std::pair<std::uint32_t, std::size_t>>& starts_;
  std::size_t next_ = 0;
};

/// Sums of a section while the run is walked through.
struct SectionSums {
  ExactSum time, programmed, rapid, pause;
  CauseSums causes;
};

std::vector<CauseCost> costs_of(const CauseSums& sums, double rounding) {
  std::vector<CauseCost> costs;
  for (std::size_t i = 0; i < all_causes().size(); ++i) {
    if (const CauseCost cost = sums.cost(i); cost.time > rounding) {
      costs.push_back(cost);
    }
  }
  std::ranges::stable_sort(costs, [](const CauseCost& a, const CauseCost& b) {
    return std::pair(a.lost, a.time) > std::pair(b.lost, b.time);
  });
  return costs;
}

}  // namespace

std::string_view time_kind_key(TimeKind kind) {
  return kind_texts[static_cast<std::size_t>(kind)].key;
}

std::string_view time_kind_title(TimeKind kind) {
  return kind_texts[static_cast<std::size_t>(kind)].title;
}

std::string_view path_title(const TimeUse& use) {
  if (use.saved_by_path > 0) {
    return use.longer_path < 0 ? "path shorter than programmed" : "path at a higher programmed feed";
  }
  return use.longer_path > 0 ? "path longer than programmed" : "path at a lower programmed feed";
}

TimeUse time_use(const Run& run, OperationSplit split, Progress* progress) {
  const Trajectory& trajectory = *run.trajectory;
  const BlendedPath& path = trajectory.path();
  const Toolpath& toolpath = *run.path;
  const Vec3 rapid_speed = axis_limit_vector(run.setup.machine, &AxisLimits::velocity);
  Sections sections = usual_sections(run, split);
  std::vector<SectionSums> of_section(sections.operations.size());
  std::array<ExactSum, time_kind_count> time, programmed;

  SectionWalk segments(sections);
  ExactSum all_programmed;
  for (std::uint32_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    const double seconds = programmed_time(toolpath, i, rapid_speed);
    const TimeKind kind = segment.kind == SegmentKind::dwell ? kind_of_pause(toolpath.pause_of(segment).kind)
                          : segment.rapid                    ? TimeKind::rapid
                                                             : TimeKind::cutting;
    programmed[static_cast<std::size_t>(kind)].add(seconds);
    all_programmed.add(seconds);
    if (const auto section = segments.at(i)) {
      of_section[*section].programmed.add(seconds);
    }
  }

  SectionWalk elements(sections);
  CauseSums causes;
  ExactSum executed_as_programmed;
  ProgressSteps steps(progress, trajectory.pieces().size());
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    steps.at(part.piece);
    const bool waits = path.kind(part.element) == ElementKind::dwell;
    const bool rapid = !waits && trajectory.is_rapid(part.element);
    const TimeKind kind = !waits ? (rapid ? TimeKind::rapid : TimeKind::cutting)
                          : part.cause.kind == CauseKind::tool_change   ? TimeKind::tool_change
                          : part.cause.kind == CauseKind::spindle_start ? TimeKind::spindle_start
                          : part.cause.kind == CauseKind::indexing      ? TimeKind::indexing
                          : part.cause.kind == CauseKind::swing         ? TimeKind::indexing
                                                                        : TimeKind::dwell;
    const double as_programmed =
        waits ? part.duration : length_of(trajectory, walk) / trajectory.feed_of(part.element);
    const std::size_t index = cause_index(limiting_cause(trajectory, part));
    time[static_cast<std::size_t>(kind)].add(part.duration);
    executed_as_programmed.add(as_programmed);
    causes.add(index, part.duration, part.duration - as_programmed);
    if (const auto section = elements.at(path.segment(part.element))) {
      SectionSums& sums = of_section[*section];
      sums.time.add(part.duration);
      (rapid ? sums.rapid : sums.pause).add(rapid || waits ? part.duration : 0);
      sums.causes.add(index, part.duration, part.duration - as_programmed);
      OperationTime& operation = sections.operations[*section];
      operation.start = std::min(operation.start, part.time);
    }
  }

  TimeUse use;
  use.cycle_time = trajectory.duration();
  use.mean_feed = run.summary.mean_feed;
  use.programmed_time = all_programmed.value();
  use.saved_by_path = use.programmed_time - executed_as_programmed.value();
  use.longer_path = trajectory.path_length() - toolpath.length();
  if (std::abs(use.longer_path) < same_length * toolpath.length()) {
    use.longer_path = 0;
  }
  for (std::size_t i = 0; i < time_kind_count; ++i) {
    use.kinds[i] = {time[i].value(), programmed[i].value()};
  }
  const double rounding = 1e-14 * use.cycle_time;
  use.causes = costs_of(causes, rounding);
  use.split = sections.split;
  for (std::size_t i = 0; i < of_section.size(); ++i) {
    OperationTime& operation = sections.operations[i];
    const SectionSums& sums = of_section[i];
    operation.all = {sums.time.value(), sums.programmed.value()};
    operation.rapid = sums.rapid.value();
    operation.pause = sums.pause.value();
    const std::vector<CauseCost> costs = costs_of(sums.causes, rounding);
    operation.worst = costs.empty() ? CauseCost() : costs.front();
  }
  std::erase_if(sections.operations,
                [](const OperationTime& operation) { return !std::isfinite(operation.start); });
  use.operations = std::move(sections.operations);
  return use;
}

}  // namespace feedscope
