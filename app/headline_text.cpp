#include "app/headline_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/print.h"
#include "core/analysis/study/recommendation.h"
#include "core/base/short_text.h"

namespace feedscope {
namespace {

std::string error_text(const ComparedRun& run) {
  return fmt::format("{}contour error {}", run.summary.actual ? "actual " : "",
                     short_length(deciding_error(run.summary)));
}

std::string only_text(OnlyChoice why) {
  switch (why) {
    case OnlyChoice::within_bound:
      return "No other run keeps the bound.";
    case OnlyChoice::within_bound_of_machine:
      return "No other run with the machine's own model keeps the bound.";
    case OnlyChoice::of_machine:
      return "No other run of the machine's own model can be taken.";
    case OnlyChoice::possible:
      break;
  }
  return "No other run can be taken.";
}

}  // namespace

std::string headline_text(std::span<const ComparedRun> runs, std::span<const std::string> names,
                          std::optional<double> within) {
  const std::vector<bool> can = can_be_chosen(runs);
  const auto choices = std::ranges::count(can, true);
  if (choices == 0 || (choices == 1 && !within)) {
    return "";
  }
  const std::optional<Recommendation> taken = recommend(runs, within);
  if (!taken) {
    const std::size_t least = *leading_run(runs, within);
    return fmt::format("No run keeps a contour error of {}. The smallest is {}, with {}.",
                       short_length(*within), short_length(deciding_error(runs[least].summary)),
                       names[least]);
  }
  const ComparedRun& run = runs[taken->run];
  const std::string& name = names[taken->run];
  const std::string time = short_time(run.summary.cycle_time);
  const auto text = [&]() -> std::string {
    switch (taken->reason) {
      case Recommendation::Reason::only:
        return fmt::format("{}: {}, {}. {}", name, time, error_text(run), only_text(why_only(runs, within)));
      case Recommendation::Reason::no_difference:
        return fmt::format("{}: {}, {}, the smallest. The others differ by less than 1 %.", name, time,
                           error_text(run));
      case Recommendation::Reason::fastest:
      case Recommendation::Reason::smallest_error:
        break;
    }
    std::string gain = fmt::format("{}: {}, {} less than {}, {}.", name, time,
                                   short_percent(taken->gain_share), names[taken->against], error_text(run));
    gain += another_model_is_faster(runs, *taken)
                ? " Runs with another model than their machine's own do not count."
                : "";
    return taken->reason == Recommendation::Reason::fastest
               ? gain
               : gain + " Others gain less than 1 % with a larger error.";
  };
  return text() + not_run_text(run.lines_not_run);
}

}  // namespace feedscope
