#include "ui/workbench/decision.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/notes/refused_lines.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/signed_number.h"
#include "ui/language/texts.h"

namespace feedscope::ui {

namespace {

struct Simulated {
  std::vector<ComparedRun> runs;
  std::vector<std::size_t> rows;
};

Simulated simulated(const RunList& runs) {
  Simulated found;
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    if (const auto result = runs.result(row)) {
      found.runs.push_back(figures_of(result->run));
      found.rows.push_back(row);
    }
  }
  return found;
}

bool can_run(const Run& run) {
  return !is_refused(run) && !is_out_of_reach(run);
}

}  // namespace

std::optional<Recommendation> recommended(const RunList& runs) {
  const Simulated found = simulated(runs);
  std::optional<Recommendation> taken = recommend(found.runs, runs.error_bound());
  if (taken) {
    taken->run = found.rows[taken->run];
    taken->against = found.rows[taken->against];
  }
  return taken;
}

QString DecisionTexts::error(const Summary& summary) {
  QString amount = amount_text(deciding_error(summary), Dimension::error);
  amount.replace(QLatin1Char(' '), QChar::Nbsp);  // no line break between number and unit
  return summary.actual ? tr("actual contour error %1").arg(amount) : tr("contour error %1").arg(amount);
}

QString DecisionTexts::none_can(std::span<const ComparedRun> runs) {
  if (std::ranges::all_of(runs, &ComparedRun::refused)) {
    return tr("The control refuses the program in all runs.");
  }
  if (std::ranges::any_of(runs, &ComparedRun::is_possible)) {
    return tr("No run has the model of its machine: none is recommended.");
  }
  return std::ranges::all_of(runs, &ComparedRun::out_of_reach)
             ? tr("The machine cannot turn its rotary axes as the program asks in any run.")
             : tr("No run is possible: the control refuses the program, or the machine cannot turn its "
                  "rotary axes as it asks.");
}

QString DecisionTexts::without_choice(std::span<const ComparedRun> runs, const QStringList& names,
                                      std::optional<double> bound) {
  const auto least = leading_run(runs, bound);
  return least ? tr("No run keeps a contour error of %1. The smallest is %2, with %3.")
                     .arg(amount_text(*bound, Dimension::error),
                          amount_text(deciding_error(runs[*least].summary), Dimension::error),
                          names[static_cast<qsizetype>(*least)])
               : none_can(runs);
}

QString DecisionTexts::against(const Run& run, const Run& other) {
  const double time = other.summary.cycle_time;
  const bool comparable = &run != &other && can_run(run) && can_run(other) && time > 0 &&
                          run.lines_not_run.size() == other.lines_not_run.size();
  return comparable ? tr("%1 %").arg(signed_number(100 * (run.summary.cycle_time / time - 1), 1))
                    : QStringLiteral("–");
}

QString DecisionTexts::single(const Summary& summary) {
  const double lost = summary.cycle_time - summary.programmed_time;
  const double share = summary.cycle_time > 0 ? std::abs(lost) / summary.cycle_time : 0;
  constexpr double rounding = 1e-6;  // of the cycle time
  const QString time = clock_text(summary.cycle_time);
  const QString rest = error(summary);
  return share < rounding ? tr("%1, as long as programmed; %2.").arg(time, rest)
         : lost > 0
             ? tr("%1, of which %2 are lost (%3); %4.").arg(time, clock_text(lost), share_text(share), rest)
             : tr("%1, %2 less than programmed (%3); %4.")
                   .arg(time, clock_text(-lost), share_text(share), rest);
}

QString DecisionTexts::only(OnlyChoice why) {
  switch (why) {
    case OnlyChoice::within_bound:
      return tr("No other run keeps the bound.");
    case OnlyChoice::within_bound_of_machine:
      return tr("No other run with the machine's own model keeps the bound.");
    case OnlyChoice::of_machine:
      return tr("No other run of the machine's own model can be taken.");
    case OnlyChoice::possible:
      break;
  }
  return tr("No other run can be taken.");
}

Decision DecisionTexts::decision(const RunList& runs) {
  if (runs.items().size() < 2) {
    return {};
  }
  const Simulated found = simulated(runs);
  const QStringList all = short_run_titles(runs.items(), runs.feed_controls());
  QStringList names;
  for (const std::size_t row : found.rows) {
    names.append(all[static_cast<qsizetype>(row)]);
  }
  return decision(found.runs, names, runs.error_bound());
}

Decision DecisionTexts::decision(std::span<const ComparedRun> runs, const QStringList& names,
                                 std::optional<double> bound) {
  if (runs.empty()) {
    return {};
  }
  const auto taken = recommend(runs, bound);
  if (!taken) {
    return {without_choice(runs, names, bound), {}};
  }
  const Summary& summary = runs[taken->run].summary;
  const QString name = names[static_cast<qsizetype>(taken->run)];
  const QString time = clock_text(summary.cycle_time);
  switch (taken->reason) {
    case Recommendation::Reason::only:
      return {tr("%1: %2, %3.").arg(name, time, error(summary)), only(why_only(runs, bound))};
    case Recommendation::Reason::no_difference:
      return {tr("No difference worth having: %1 takes %2, %3.").arg(name, time, error(summary)),
              tr("The cycle times differ by less than 1 %. No run has a smaller error.")};
    case Recommendation::Reason::fastest:
    case Recommendation::Reason::smallest_error:
      break;
  }
  QString rule = taken->reason == Recommendation::Reason::fastest
                     ? tr("The fastest run. None within 1 % of it has a smaller error.")
                     : tr("The smallest error within 1 % of the fastest run.");
  if (another_model_is_faster(runs, *taken)) {
    rule += ' ' + tr("Runs with another model than their machine's own do not count.");
  }
  return {tr("%1: %2, %3 less than %4, %5.")
              .arg(name, time, share_text(taken->gain_share), names[static_cast<qsizetype>(taken->against)],
                   error(summary)),
          rule};
}

}  // namespace feedscope::ui
