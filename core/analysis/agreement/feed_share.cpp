#include "core/analysis/agreement/feed_share.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace feedscope {
namespace {

constexpr double at_feed = 0.995;     // of the programmed feed, the run has it
constexpr double least_length = 0.1;  // of all that is compared
constexpr std::size_t least_cells = 5;
constexpr double equal_share = 0.01;  // relative difference up to which two shares count as equal
constexpr double most = 0.8;          // of the length at the programmed feed, with the same share
constexpr double about_one = 0.02;

/// Programmed along the whole cell [mm/s]; 0 where it changes, or for a rapid.
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

}  // namespace

std::optional<double> feed_share(const Agreement& agreement, const ProgrammedCourse& course,
                                 const Toolpath& toolpath) {
  std::vector<std::pair<double, double>> shares;  // with the length of their cells
  double compared = 0;
  double length = 0;
  for (const AgreementCell& cell : agreement.cells) {
    compared += cell.length;
    const double feed = programmed_feed(cell, course, toolpath);
    if (feed > 0 && cell.simulated_feed() >= at_feed * feed) {
      shares.emplace_back(cell.measured_feed() / feed, cell.length);
      length += cell.length;
    }
  }
  if (shares.size() < least_cells || length < least_length * compared) {
    return std::nullopt;
  }
  std::ranges::sort(shares);
  double below = 0;
  double middle = shares.back().first;
  for (const auto& [share, part] : shares) {
    below += part;
    if (2 * below >= length) {
      middle = share;
      break;
    }
  }
  double same = 0;
  for (const auto& [share, part] : shares) {
    same += std::abs(share - middle) <= equal_share * middle ? part : 0;
  }
  return same >= most * length && std::abs(middle - 1) > about_one ? std::optional(middle) : std::nullopt;
}

void add_feed_remark(TraceOnProgram& trace, const Agreement& agreement, const ProgrammedCourse& course,
                     const Toolpath& toolpath) {
  if (const std::optional<double> share = feed_share(agreement, course, toolpath)) {
    constexpr double thousandth = 1e-3;
    const bool in_milliseconds = std::abs(*share / thousandth - 1) < 0.1;
    trace.remarks.insert(
        trace.remarks.begin(),
        {.severity = Severity::warning,
         .line = 0,
         .column = 0,
         .code = "trace-override",
         .message =
             fmt::format("where the simulation runs at the programmed feed, the trace runs at {:.3g} % of it",
                         100 * *share),
         .hint = in_milliseconds
                     ? "its times are in milliseconds: give their column the unit, as --columns time=1:ms"
                     : "a feed override, or times of another rate: set the feed override of the simulation "
                       "to it, or "
                       "give the right rate; else limits that are found from the trace are those of the "
                       "override"});
  }
}

}  // namespace feedscope
