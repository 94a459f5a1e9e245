#include "app/identification_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/print.h"
#include "core/base/units.h"
#include "core/identification/recordings.h"
#include "core/machine/undetermined.h"

namespace feedscope {
namespace {

std::string parameters_text(const Identification& found) {
  TextTable table;
  table.add({"", "value", "+-", "unit", "before", ""});
  bool any_changed = false;
  for (const IdentifiedParameter& one : found.parameters) {
    if (one.told) {
      table.add({one.parameter.key, fmt::format("{:.5g}", one.value), fmt::format("{:.2g}", one.uncertainty),
                 one.parameter.unit, fmt::format("{:.4g}", one.start), ""});
    } else {
      const bool is_changed = one.value != one.start;
      any_changed = any_changed || is_changed;
      table.add({one.parameter.key, is_changed ? fmt::format("({:.4g})", one.value) : "-", "",
                 one.parameter.unit, fmt::format("{:.4g}", one.start),
                 (one.at_least ? fmt::format("at least {:.4g}. ", *one.at_least) : "") + one.reason +
                     (one.told_by.empty() ? "" : fmt::format(" Test program: {}", one.told_by))});
    }
  }
  return table.text("lrrlrl") +
         (!any_changed     ? ""
          : found.explains ? "(...): not told, but in use, since it explains the traces as well or better\n"
                           : "(...): not told; what comes closest, and in no machine file\n");
}

/// "2 ms (servo period of the machine)"; "-" for times of sections.
std::string rate_text(const SamplingRate& rate) {
  return rate.period > 0 ? fmt::format("{:.4g} ms ({})", units::to_ms(rate.period), title_of(rate.clock))
                         : "-";
}

std::string traces_text(const Identification& found, const std::vector<std::string>& traces) {
  TextTable table;
  table.add({"trace", "one sample each", "measured", "simulated", "difference", "feed rms mm/min"});
  for (std::size_t i = 0; i < found.agreements.size(); ++i) {
    const Agreement& agreement = found.agreements[i];
    table.add(
        {traces[i], rate_text(agreement.rate), time_text(agreement.measured_time),
         time_text(agreement.simulated_time), signed_text(100 * agreement.time_error(), 2) + " %",
         found.sections[i].empty() ? fmt::format("{:.1f}", units::to_mm_min(agreement.feed_rms)) : "-"});
  }
  return table.text("llrrrr");
}

/// Drives that were fitted, and the part of the following errors that they explain.
std::string drives_text(const Identification& found) {
  if (found.drives.empty()) {
    return "";
  }
  TextTable table;
  table.add({"drive", "samples", "following error rms um", "left over rms um", "explained"});
  for (const DriveFit& drive : found.drives) {
    table.add({std::string(1, drive.axis), fmt::format("{}", drive.samples),
               fmt::format("{:.2f}", units::to_um(drive.following_error)),
               fmt::format("{:.2f}", units::to_um(drive.left)),
               drive.explains ? "yes"
               : drive.delay != 0
                   ? fmt::format("no: actual positions seem {:.2g} ms late", units::to_ms(drive.delay))
                   : "no"});
  }
  return table.text("lrrrl");
}

/// Of each table, the sections with the largest deviation of a run.
std::string sections_text(const Identification& found) {
  constexpr std::size_t most = 5;
  std::string text;
  for (const std::vector<SectionAgreement>& all : found.sections) {
    if (all.empty()) {
      continue;
    }
    std::vector<SectionAgreement> worst = all;
    std::ranges::stable_sort(worst, std::ranges::greater(), [](const SectionAgreement& one) {
      return std::abs(one.simulated_time - one.measured_time);
    });
    worst.resize(std::min(worst.size(), most));
    TextTable table;
    table.add({"sections missed most", "measured s", "simulated s", "difference s"});
    for (const SectionAgreement& one : worst) {
      table.add({one.section, fmt::format("{:.4f}", one.measured_time),
                 fmt::format("{:.4f}", one.simulated_time),
                 signed_text(one.simulated_time - one.measured_time, 4)});
    }
    text += table.text("lrrr");
  }
  return text;
}

/// States that a model does not explain the traces. The drives are found without it and reported all the
/// same.
std::string unexplained_text(const Identification& found) {
  if (found.explains) {
    return "";
  }
  const auto is_drive = [](const IdentifiedParameter& one) { return is_drive_parameter(one.parameter); };
  const std::string id = found.setup.model->info().id;
  const bool drives_alone = !found.parameters.empty() && std::ranges::all_of(found.parameters, is_drive);
  if (drives_alone) {
    return fmt::format(
        "model {} as it is does not explain the times of the traces; drives are found without it\n", id);
  }
  const bool has_drive = std::ranges::any_of(found.parameters, is_drive);
  const std::vector<std::string> held = held_parameters(found);
  const std::string advice =
      held.empty()
          ? "try another --model"
          : fmt::format("{} {} held: look for {} too (--fit), or try another --model", fmt::join(held, ", "),
                        held.size() == 1 ? "was" : "were", held.size() == 1 ? "it" : "them");
  return fmt::format("model {} does not explain the traces: no value of it is told; {}{}\n", id, advice,
                     has_drive ? " (drives are found without it)" : "");
}

}  // namespace

std::string undetermined_text(const Identification& found) {
  std::vector<std::string> keys;
  for (const auto& [key, source] : found.setup.machine.provenance) {
    if (is_undetermined(source)) {
      keys.push_back(key);
    }
  }
  return keys.empty() ? ""
                      : fmt::format(
                            "not determined, and said so in the file: {}; a simulation that they limit "
                            "says how much of its time\n",
                            fmt::join(keys, ", "));
}

std::string identification_text(const std::vector<Identification>& models,
                                const std::vector<std::string>& traces,
                                const std::vector<UnfittedModel>& unfitted) {
  std::string text;
  if (models.size() + unfitted.size() > 1) {
    TextTable table;
    table.add({"model", "residual (noise = 1)", "feed error", "explains the traces"});
    for (const Identification& found : models) {
      table.add({found.setup.model->info().id, fmt::format("{:.2f}", found.residual),
                 fmt::format("{:.2f} %", 100 * found.feed_error),
                 explains_roughly(found, models.front()) ? "roughly"
                 : found.explains                        ? "yes"
                                                         : "no"});
    }
    for (const UnfittedModel& one : unfitted) {
      table.add({one.id, "-", "-", "not fitted"});
    }
    text += table.text("lrrl");
    for (const UnfittedModel& one : unfitted) {
      text += fmt::format("{}: {}\n", one.id, one.reason.english());
    }
    text += "\n";
  }
  const Identification& best = models.front();
  text += fmt::format("model {}, {} simulations\n", best.setup.model->info().id, best.simulations);
  text += parameters_text(best) + traces_text(best, traces) + drives_text(best) + sections_text(best);
  return text + unexplained_text(best);
}

}  // namespace feedscope
