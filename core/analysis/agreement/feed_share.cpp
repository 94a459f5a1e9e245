#include "core/analysis/agreement/feed_share.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace feedscope {
namespace {

constexpr double at_feed = 0.995;  // of the programmed feed: from here the run counts as having reached it
constexpr double above_feed = 1.02;
constexpr double least_length = 0.1;  // share of all that is compared
constexpr std::size_t least_cells = 5;
constexpr double equal_share = 0.01;    // relative difference up to which two shares count as equal
constexpr double most = 0.8;            // share of the length at the programmed feed with the common ratio
constexpr double most_exceeding = 0.2;  // of the length above the programmed feed, near the largest ratio
constexpr double top_quantile = 0.9;
constexpr double about_one = 0.02;
constexpr const char* rate_code = "trace-rate";

/// Ratios, each weighted by the length of its cell.
using WeightedRatios = std::vector<std::pair<double, double>>;

double summed_length(const WeightedRatios& ratios) {
  double length = 0;
  for (const auto& [ratio, part] : ratios) {
    length += part;
  }
  return length;
}

/// Weighted `quantile` of the ratios, if at least `most_of` of the weight is within `equal` of it. None for
/// few cells or a weight below `least`.
std::optional<double> common_ratio(WeightedRatios ratios, double least, double equal, double most_of,
                                   double quantile = 0.5) {
  const double length = summed_length(ratios);
  if (ratios.size() < least_cells || length < least) {
    return std::nullopt;
  }
  std::ranges::sort(ratios);
  double below = 0;
  double middle = ratios.back().first;
  for (const auto& [ratio, part] : ratios) {
    below += part;
    if (below >= quantile * length) {
      middle = ratio;
      break;
    }
  }
  double same = 0;
  for (const auto& [ratio, part] : ratios) {
    same += std::abs(ratio - middle) <= equal * middle ? part : 0;
  }
  return same >= most_of * length ? std::optional(middle) : std::nullopt;
}

/// Feed programmed along the whole cell [mm/s]; 0 if it changes or for a rapid.
double programmed_feed(const AgreementCell& cell, const ProgrammedCourse& course, const Toolpath& toolpath) {
  const std::uint32_t last = course.segment_at(cell.s + cell.length);
  const double feed = toolpath.segments[last].feed;
  for (std::uint32_t i = course.segment_at(cell.s); i < last; ++i) {
    if (toolpath.segments[i].feed != feed) {
      return 0;
    }
  }
  return feed;
}

/// Relative difference of the simulated feed of a cell from those of its neighbours; none without neighbours.
std::optional<double> change_at(const std::vector<AgreementCell>& cells, std::size_t i) {
  constexpr double touching = 1e-6;  // [mm]
  const auto follows = [&](std::size_t before) {
    return std::abs(cells[before].s + cells[before].length - cells[before + 1].s) <= touching;
  };
  if (i == 0 || i + 1 >= cells.size() || !follows(i - 1) || !follows(i)) {
    return std::nullopt;
  }
  const double feed = cells[i].simulated_feed();
  const double change = std::max(std::abs(cells[i - 1].simulated_feed() - feed),
                                 std::abs(cells[i + 1].simulated_feed() - feed));
  return feed > 0 ? std::optional(change / feed) : std::nullopt;
}

/// Whether the feeds are a thousandth of their true values.
bool has_milliseconds(double ratio) {
  constexpr double thousandth = 1e-3;
  return std::abs(ratio / thousandth - 1) < 0.1;
}

constexpr Translatable unit_hint =
    NC_("core", "its times are in milliseconds: give their column the unit, as --columns time=1:ms");

Diagnostic feed_remark(double share, const TraceOnProgram& trace) {
  const bool is_rate = trace.rate.clock != TraceClock::times && share > 1;
  return {
      .severity = Severity::warning,
      .line = 0,
      .column = 0,
      .code = is_rate ? rate_code : "trace-override",
      .message =
          is_rate
              ? message(NC_("core",
                            "the trace runs at {:.3g} % of the programmed feed: its sampling rate is wrong, "
                            "or a feed override was set"),
                        100 * share)
              : message(
                    NC_("core",
                        "where the simulation runs at the programmed feed, the trace runs at {:.3g} % of it"),
                    100 * share),
      .hint = is_rate ? message(NC_("core",
                                    "give the right rate, at most {0:.0f} samples a second, as --columns "
                                    "linuxcnc,rate={0:.0f}; or set the feed override of the simulation"),
                                1 / (trace.rate.period * share))
              : has_milliseconds(share)
                  ? unit_hint
                  : NC_("core",
                        "a feed override, or times of another rate: set the feed override of the simulation "
                        "to it, or give the right rate; else limits that are found from the trace are those "
                        "of the override")};
}

/// `what`: shows that the trace runs `ratio` times as fast as the motion did.
Diagnostic rate_remark(double ratio, Message what, const TraceOnProgram& trace) {
  return {
      .severity = Severity::warning,
      .line = 0,
      .column = 0,
      .code = rate_code,
      .message = std::move(what),
      .hint = has_milliseconds(ratio) ? unit_hint
              : trace.rate.clock == TraceClock::times
                  ? NC_("core",
                        "give the right rate or unit of its times; else limits that are found from the trace "
                        "are wrong")
                  : message(NC_("core",
                                "give the right rate, {0:.0f} samples a second, as --columns "
                                "linuxcnc,rate={0:.0f}; else limits that are found from the trace are wrong"),
                            1 / (trace.rate.period * ratio))};
}

}  // namespace

std::optional<double> feed_share(const Agreement& agreement, const ProgrammedCourse& course,
                                 const Toolpath& toolpath) {
  WeightedRatios reached;
  WeightedRatios exceeded;
  double compared = 0;
  for (const AgreementCell& cell : agreement.cells) {
    compared += cell.length;
    const double feed = programmed_feed(cell, course, toolpath);
    if (feed > 0 && cell.simulated_feed() >= at_feed * feed) {
      reached.emplace_back(cell.measured_feed() / feed, cell.length);
    }
    if (feed > 0 && cell.measured_feed() > above_feed * feed) {
      exceeded.emplace_back(cell.measured_feed() / feed, cell.length);
    }
  }
  const double least = least_length * compared;
  const std::optional<double> at_programmed = common_ratio(std::move(reached), least, equal_share, most);
  const std::optional<double> share =
      at_programmed ? at_programmed
                    : common_ratio(std::move(exceeded), least, equal_share, most_exceeding, top_quantile);
  return share && std::abs(*share - 1) > about_one ? share : std::nullopt;
}

std::optional<double> pace_ratio(const Agreement& agreement) {
  constexpr double even = 0.003;  // change of the simulated feed from cell to cell, as a share
  constexpr double uneven = 0.01;
  constexpr double equal = 0.03;
  constexpr double clearly_one = 0.05;
  constexpr double least_uneven = 0.01;  // share of all that is compared
  WeightedRatios steady;
  WeightedRatios changing;
  double compared = 0;
  for (std::size_t i = 0; i < agreement.cells.size(); ++i) {
    const AgreementCell& cell = agreement.cells[i];
    compared += cell.length;
    const std::optional<double> change = change_at(agreement.cells, i);
    if (change && (*change < even || *change > uneven)) {
      (*change < even ? steady : changing)
          .emplace_back(cell.measured_feed() / cell.simulated_feed(), cell.length);
    }
  }
  const auto at_speed = common_ratio(std::move(steady), least_length * compared, equal, most);
  const auto on_ramps = common_ratio(std::move(changing), least_uneven * compared, equal, most);
  const bool is_same = at_speed && on_ramps && std::abs(*on_ramps / *at_speed - 1) <= equal;
  return is_same && std::abs(*at_speed - 1) > clearly_one ? at_speed : std::nullopt;
}

std::optional<double> dwell_ratio(const TimeLaw& trace, const TimeLaw& run, const ProgrammedCourse& course,
                                  const Toolpath& toolpath) {
  constexpr double shortest = 0.1;  // [s]
  constexpr double reach = 0.01;    // [mm] to both sides: motions of the machine end within it
  constexpr double equal = 0.05;
  constexpr double clearly_above = 1.1;
  constexpr double another_unit = 50;
  const double from = std::max(trace.first_s(), run.first_s()) + reach;
  const double to = std::min(trace.last_s(), run.last_s()) - reach;
  WeightedRatios ratios;
  for (std::uint32_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    const double s = course.start_of(i);
    if (segment.kind != SegmentKind::dwell || toolpath.pause_of(segment).kind != Pause::dwell || s < from ||
        s > to) {
      continue;
    }
    const double simulated = run.at(s + reach) - run.at(s - reach);
    const double recorded = trace.at(s + reach) - trace.at(s - reach);
    if (simulated > shortest && recorded > 0) {
      ratios.emplace_back(simulated / recorded, simulated);
    }
  }
  const auto ratio = common_ratio(std::move(ratios), 0, equal, most);
  return ratio && *ratio > clearly_above && *ratio < another_unit ? ratio : std::nullopt;
}

void add_feed_remark(TraceOnProgram& trace, const Agreement& agreement, const ProgrammedCourse& course,
                     const Toolpath& toolpath) {
  const auto insert = [&](Diagnostic remark) {
    trace.remarks.insert(trace.remarks.begin(), std::move(remark));
  };
  if (const std::optional<double> pace = pace_ratio(agreement)) {
    insert(rate_remark(*pace,
                       message(NC_("core",
                                   "the trace runs at {:.3g} % of the simulated feed at even speed and where "
                                   "the machine speeds up or slows down: its sampling rate is wrong"),
                               100 * *pace),
                       trace));
  } else if (const auto ratio = dwell_ratio(trace.law, agreement.simulated, course, toolpath)) {
    insert(rate_remark(*ratio,
                       message(NC_("core",
                                   "the trace stands still for {:.3g} % of the time of the dwells of the "
                                   "program: its sampling rate is wrong"),
                               100 / *ratio),
                       trace));
  } else if (const std::optional<double> share = feed_share(agreement, course, toolpath)) {
    insert(feed_remark(*share, trace));
  }
}

const Diagnostic* wrong_rate_of(const Trace& trace, const TraceOnProgram& found) {
  if (trace.clock == TraceClock::times) {
    return nullptr;
  }
  for (const std::vector<Diagnostic>* messages : {&trace.notes, &found.remarks}) {
    const auto wrong = std::ranges::find(*messages, rate_code, &Diagnostic::code);
    if (wrong != messages->end()) {
      return &*wrong;
    }
  }
  return nullptr;
}

}  // namespace feedscope
