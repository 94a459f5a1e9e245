#include "ui/time_use/time_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <functional>

#include "ui/language/core_texts.h"
#include "ui/language/operation_title.h"
#include "ui/language/remedy_text.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/language/time_texts.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t most_rows = 8;
constexpr double worth_a_row = 1e-3;  // of the cycle time

/// Builds the rows in the user's language.
class TimeRows {
  Q_DECLARE_TR_FUNCTIONS(TimeRows)

 public:
  TimeRows(const TimeReport& report, const Run& run) : report_(report), use_(report.use), run_(run) {}

  TimeSection kinds() const {
    TimeSection section{{tr("What it consists of"), tr("Time"), tr("Lost")}, {}};
    for (std::size_t i = 0; i < time_kind_count; ++i) {
      const TimeShare& share = use_.kinds[i];
      if (share.time > 0) {
        TimeRow row = time_row(TimeTexts::kind(static_cast<TimeKind>(i)), share.time, share.lost());
        row.tip = tr("%1 of the cycle time; %2 at the programmed feed")
                      .arg(TimeTexts::percent(share.time, use_.cycle_time), clock_text(share.programmed));
        section.rows.push_back(std::move(row));
      }
    }
    return section;
  }

  TimeSection places() const {
    TimeSection section{{tr("Places that lose most"), tr("Lost"), tr("Share")}, {}};
    for (const SlowGroup& group : report_.slow.groups) {
      if (section.rows.size() == most_rows || group.loss < worth_a_row * use_.cycle_time) {
        break;
      }
      TimeRow row;
      row.cells = {TimeTexts::group(group), TimeTexts::change(group.loss),
                   TimeTexts::percent(group.loss, report_.slow.loss)};
      row.tip = tr("%1.\nClick to go to the worst place, in line %2.")
                    .arg(TimeTexts::in_common(group), QString::number(group.worst.front().line));
      row.share = group.loss / report_.slow.loss;
      row.place = group.worst.front();
      for (const SlowPlace& place : group.worst) {
        TimeRow one;
        one.cells = {tr("Line %1").arg(QString::number(place.line)), TimeTexts::change(place.loss),
                     TimeTexts::percent(place.loss, report_.slow.loss)};
        one.place = place;
        row.rows.push_back(std::move(one));
      }
      section.rows.push_back(std::move(row));
    }
    return section;
  }

  TimeSection changes() const {
    const ChangeTrials& trials = report_.changes;
    TimeSection section{{tr("What would help (simulated)"), tr("Gain"), tr("Error")}, {}};
    for (const std::size_t i : trials.best) {
      section.rows.push_back(change_row(trials.tried[i]));
    }
    if (trials.together) {
      TimeRow row = change_row(*trials.together);
      row.tip = row.cells[0] + QLatin1Char('\n') + row.tip;
      row.cells[0] = tr("Those of this machine together");
      section.rows.push_back(std::move(row));
    }
    TimeRow others;
    for (std::size_t i = 0; i < trials.tried.size(); ++i) {
      if (std::ranges::find(trials.best, i) == trials.best.end() && trials.tried[i].failure.empty() &&
          trials.tried[i].cycle_time < use_.cycle_time) {
        others.rows.push_back(change_row(trials.tried[i]));
      }
    }
    if (!others.rows.empty()) {
      others.cells[0] = tr("Also simulated");
      section.rows.push_back(std::move(others));
    }
    if (section.rows.empty() && !trials.tried.empty()) {
      TimeRow none;
      none.cells[0] = tr("None of the changes that were simulated helps");
      section.rows.push_back(std::move(none));
    }
    return section;
  }

  TimeSection causes() const {
    TimeSection section{{tr("Limited by, with braking for it"), tr("Time"), tr("Lost")}, {}};
    CauseCost rest;
    const double shown = least_shown();
    for (const CauseCost& cost : use_.causes) {
      if (section.rows.size() < most_rows && weight_of(cost) >= shown) {
        TimeRow row = time_row(TimeTexts::cause(cost.cause), cost.time, cost.lost);
        row.place = worst_of(cost.cause);
        section.rows.push_back(std::move(row));
      } else {
        rest.time += cost.time;
        rest.lost += cost.lost;
      }
    }
    if (rest.time > worth_a_row * use_.cycle_time) {
      section.rows.push_back(time_row(tr("Others"), rest.time, rest.lost));
    }
    return section;
  }

  TimeSection operations() const {
    TimeSection section{{tr("Operations"), tr("Time"), tr("Lost")}, {}};
    for (const OperationTime& operation : use_.operations) {
      TimeRow row = time_row(operation_title(operation.title, operation.line, use_.split), operation.all.time,
                             operation.all.lost());
      row.time = operation.start;
      row.tip = tr("From line %1; %2 of it rapids. It loses most to: %3.")
                    .arg(QString::number(operation.line), clock_text(operation.rapid),
                         shown_cause(operation.worst.cause));
      section.rows.push_back(std::move(row));
    }
    return section;
  }

 private:
  TimeRow time_row(const QString& title, double time, double lost) const {
    TimeRow row;
    row.cells = {title, clock_text(time), TimeTexts::change(lost)};
    row.share = use_.cycle_time > 0 ? time / use_.cycle_time : 0;
    return row;
  }

  TimeRow change_row(const TriedChange& change) const {
    TimeRow row;
    const double gain = use_.cycle_time - change.cycle_time;
    row.cells = {remedy_text(change.remedy, run_.setup), TimeTexts::gain(gain),
                 change.cutting_contour_error ? amount_text(*change.cutting_contour_error, Dimension::error)
                                              : QString()};
    row.share = use_.cycle_time > 0 ? gain / use_.cycle_time : 0;
    row.tip = tr("%1 instead of %2 (%3 less).")
                  .arg(clock_text(change.cycle_time), clock_text(use_.cycle_time),
                       TimeTexts::percent(gain, use_.cycle_time));
    if (change.cutting_contour_error) {
      row.tip +=
          QLatin1Char('\n') + tr("Max. contour error %1, now %2.")
                                  .arg(amount_text(*change.cutting_contour_error, Dimension::error),
                                       amount_text(run_.summary.cutting_contour_error, Dimension::error));
    }
    row.tip += QLatin1Char('\n') + tr("Whether machine, tool and material bear it is not checked.");
    row.remedy = change.remedy;
    return row;
  }

  static double weight_of(const CauseCost& cost) { return std::max(cost.time, std::abs(cost.lost)); }

  /// Weight of the last cause with a row.
  double least_shown() const {
    std::vector<double> weights;
    for (const CauseCost& cost : use_.causes) {
      weights.push_back(weight_of(cost));
    }
    std::ranges::sort(weights, std::greater());
    const double least = worth_a_row * use_.cycle_time;
    return weights.size() > most_rows ? std::max(least, weights[most_rows - 1]) : least;
  }

  /// The place with the largest loss to a cause, if it is among the worst of a group.
  std::optional<SlowPlace> worst_of(Cause cause) const {
    std::optional<SlowPlace> worst;
    for (const SlowGroup& group : report_.slow.groups) {
      for (const SlowPlace& place : group.worst) {
        if (place.cause == cause && (!worst || place.loss > worst->loss)) {
          worst = place;
        }
      }
    }
    return worst;
  }

  const TimeReport& report_;
  const TimeUse& use_;
  const Run& run_;
};

}  // namespace

std::vector<TimeSection> time_sections(const TimeReport& report, const Run& run) {
  const TimeRows rows(report, run);
  std::vector<TimeSection> sections{rows.kinds(), rows.places(), rows.changes(), rows.causes(),
                                    rows.operations()};
  std::erase_if(sections, [](const TimeSection& section) { return section.rows.empty(); });
  return sections;
}

}  // namespace feedscope::ui
