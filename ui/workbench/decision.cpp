#include "ui/workbench/decision.h"

#include <algorithm>

#include "ui/language/shown_numbers.h"
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

QString DecisionTexts::none_keeps(std::span<const ComparedRun> runs, const QStringList& names, double bound) {
  const std::vector<bool> can = can_be_chosen(runs);
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (can[i] && (!least || deciding_error(runs[i].summary) < deciding_error(runs[*least].summary))) {
      least = i;
    }
  }
  return least ? tr("No run keeps a contour error of %1. The smallest is %2, with %3.")
                     .arg(amount_text(bound, Dimension::error),
                          amount_text(deciding_error(runs[*least].summary), Dimension::error),
                          names[static_cast<qsizetype>(*least)])
               : QString();
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
  const auto taken = recommend(runs, bound);
  if (!taken) {
    return {bound ? none_keeps(runs, names, *bound) : QString(), {}};
  }
  const Summary& summary = runs[taken->run].summary;
  const QString name = names[static_cast<qsizetype>(taken->run)];
  const QString time = clock_text(summary.cycle_time);
  switch (taken->reason) {
    case Recommendation::Reason::only:
      return {tr("%1: %2, %3.").arg(name, time, error(summary)), only(why_only(runs, bound))};
    case Recommendation::Reason::no_difference:
      return {tr("No difference worth having: %1 takes %2, %3.").arg(name, time, error(summary)),
              tr("The cycle times differ by less than 1 %. This run has the smallest error.")};
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
