#include "core/analysis/notes/slower_tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/analysis/notes/tolerance_effect.h"

namespace feedscope {
namespace {

struct Candidate {
  std::size_t run;
  double tolerance;
};

bool differ_in_tolerance_alone(const Setup& a, const Setup& b) {
  const auto without_tolerance = [](Settings settings) {
    settings.set("contour_tolerance_mm", 0.0);
    return settings;
  };
  return a.model == b.model && a.machine.id == b.machine.id && a.machine.axes == b.machine.axes &&
         without_tolerance(a.settings) == without_tolerance(b.settings);
}

/// Finds the cause whose time grows most from one run to the other.
void find_cause(const Summary& narrow, const Summary& wide, SlowerTolerance& slower) {
  for (std::size_t i = 0; i < wide.time_by_cause.size(); ++i) {
    const double more = wide.time_by_cause[i] - narrow.time_by_cause[i];
    if (more > slower.cause_more) {
      slower.cause = all_causes()[i];
      slower.cause_more = more;
    }
  }
}

}  // namespace

std::vector<ToleranceRun> tolerance_runs(std::span<const ComparedRun> runs) {
  std::vector<ToleranceRun> all;
  all.reserve(runs.size());
  for (const ComparedRun& run : runs) {
    all.push_back({&run.setup, &run.summary});
  }
  return all;
}

std::vector<SlowerTolerance> slower_with_wider_tolerance(std::span<const ToleranceRun> runs) {
  constexpr double min_growth = 1e-4;
  std::vector<std::vector<Candidate>> groups;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::optional<double> tolerance = contour_tolerance(*runs[i].setup);
    if (!tolerance) {
      continue;
    }
    const auto group = std::ranges::find_if(groups, [&](const auto& one) {
      return differ_in_tolerance_alone(*runs[one.front().run].setup, *runs[i].setup);
    });
    (group == groups.end() ? groups.emplace_back() : *group).push_back({i, *tolerance});
  }
  std::vector<SlowerTolerance> slower;
  for (auto& group : groups) {
    std::ranges::stable_sort(group, {}, &Candidate::tolerance);
    const auto time = [&](const Candidate& one) { return runs[one.run].summary->cycle_time; };
    SlowerTolerance worst;
    const Candidate* fastest = &group.front();
    for (const Candidate& one : group) {
      const double more = time(one) - time(*fastest);
      if (one.tolerance > fastest->tolerance && more > std::max(worst.more, min_growth * time(*fastest))) {
        worst = {fastest->run, one.run, fastest->tolerance, one.tolerance, more, {}, 0};
      }
      if (time(one) < time(*fastest)) {
        fastest = &one;
      }
    }
    if (worst.more > 0) {
      find_cause(*runs[worst.narrow].summary, *runs[worst.wide].summary, worst);
      slower.push_back(worst);
    }
  }
  return slower;
}

std::string to_string(const SlowerTolerance& slower, std::span<const ToleranceRun> runs) {
  const ToleranceRun& wide = runs[slower.wide];
  return fmt::format(
      "{} on {}: a contour tolerance of {} mm takes longer than {} mm, {:.3f} s against {:.3f} s. Largest "
      "increase by cause: {}, {:.3f} s more.{}{}",
      wide.setup->model->info().id, wide.setup->machine.name, slower.wide_value, slower.narrow_value,
      wide.summary->cycle_time, runs[slower.narrow].summary->cycle_time, cause_title(slower.cause),
      slower.cause_more, is_by_blends(slower) ? " " : "", why_slower(slower));
}

}  // namespace feedscope
