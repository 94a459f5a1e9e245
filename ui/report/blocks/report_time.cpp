#include "ui/report/blocks/report_time.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/time/time_report.h"
#include "core/base/units.h"
#include "ui/language/operation_title.h"
#include "ui/language/remedy_text.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/language/time_texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t most_rows = 12;
constexpr double worth_a_row = 5e-4;  // of the cycle time

QString seconds(double time) {
  return fixed(time, 3);
}

QString percent(double part, double of) {
  return of > 0 ? fixed(100 * part / of, 1) : QStringLiteral("–");
}

QString small(const QString& text) {
  return QStringLiteral("<p class=\"small\">%1</p>\n").arg(text);
}

QString kinds_table(const TimeUse& use) {
  HtmlTable table("lrrrr", {36, 16, 16, 16, 16});
  table.add_head({QString(), ReportWords::tr("Time [s]"), ReportWords::tr("Share [%]"),
                  ReportWords::tr("Programmed [s]"), ReportWords::tr("Lost [s]")});
  const auto add = [&](const QString& title, const TimeShare& share) {
    table.add({title, seconds(share.time), percent(share.time, use.cycle_time), seconds(share.programmed),
               seconds(share.lost())});
  };
  for (std::size_t i = 0; i < time_kind_count; ++i) {
    const TimeShare& share = use.kinds[i];
    if (share.time > 0 || share.programmed > 0) {
      add(TimeTexts::kind(static_cast<TimeKind>(i)), share);
    }
  }
  add(QStringLiteral("<b>%1</b>").arg(ReportWords::tr("All")), {use.cycle_time, use.programmed_time});
  return table.html();
}

/// The longest operations, in program order.
std::vector<std::size_t> longest_operations(const TimeUse& use) {
  std::vector<std::size_t> rows(use.operations.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::stable_sort(rows, std::greater(), [&](std::size_t i) { return use.operations[i].all.time; });
  rows.resize(std::min(rows.size(), most_rows));
  std::ranges::sort(rows);
  return rows;
}

QString operations_table(const TimeUse& use) {
  if (use.operations.empty()) {
    return {};
  }
  HtmlTable table("lrrrrrl", {26, 8, 11, 9, 11, 11, 24});
  table.add_head({use.split == OperationSplit::tool ? ReportWords::tr("Operation by tool")
                                                    : ReportWords::tr("Operation by comment"),
                  ReportWords::tr("Line"), ReportWords::tr("Time [s]"), ReportWords::tr("Share [%]"),
                  ReportWords::tr("Lost [s]"), ReportWords::tr("Rapids [s]"),
                  ReportWords::tr("Loses most to")});
  for (const std::size_t row : longest_operations(use)) {
    const OperationTime& operation = use.operations[row];
    table.add({html_text(operation_title(operation.title, operation.line, use.split)),
               QString::number(operation.line), seconds(operation.all.time),
               percent(operation.all.time, use.cycle_time), seconds(operation.all.lost()),
               seconds(operation.rapid),
               operation.loses() ? html_text(TimeTexts::cause(operation.worst.cause)) : QStringLiteral("–")});
  }
  QString html = table.html();
  if (use.operations.size() > most_rows) {
    html += small(ReportWords::tr("The %1 operations of %2 that take longest.")
                      .arg(most_rows)
                      .arg(use.operations.size()));
  }
  return html;
}

QString change_title(const ReportInput& input, const TriedChange& change) {
  return html_text(remedy_text(change.remedy, input.run().shown->run.setup));
}

}  // namespace

ReportInput with_time_report(ReportInput input, bool with_changes, Progress* progress) {
  const Run& run = input.run().shown->run;
  TimeReport report;
  report.use = time_use(run, OperationSplit::none, progress);
  report.slow = find_slow_groups(*run.trajectory, progress);
  if (with_changes && !is_refused(run) && report.use.cycle_time > 0) {
    report.changes = try_changes(run, changes_worth_trying(run, report.use), progress);
  }
  input.time = std::make_shared<const TimeReport>(std::move(report));
  return input;
}

QString time_use_block(const ReportInput& input) {
  const TimeReport& report = *input.time;
  const Run& run = input.run().shown->run;
  if (is_refused(run)) {
    return paragraph(TimeTexts::refusal(run));
  }
  if (!(report.use.cycle_time > 0)) {
    return {};
  }
  return paragraph(TimeTexts::conclusion(report, run)) + kinds_table(report.use) +
         operations_table(report.use);
}

QString time_places_block(const ReportInput& input) {
  if (is_refused(input.run().shown->run)) {
    return {};
  }
  const TimeReport& report = *input.time;
  HtmlTable table("llrrrr", {32, 32, 10, 9, 8, 9});
  table.add_head({ReportWords::tr("Places"), ReportWords::tr("In common"), ReportWords::tr("Lost [s]"),
                  ReportWords::tr("Share [%]"), ReportWords::tr("Number"), ReportWords::tr("Worst line")});
  std::size_t rows = 0;
  for (const SlowGroup& group : report.slow.groups) {
    if (rows == most_rows || group.loss < worth_a_row * report.use.cycle_time) {
      break;
    }
    ++rows;
    table.add({html_text(TimeTexts::group(group)), html_text(TimeTexts::measure(group)), seconds(group.loss),
               percent(group.loss, report.slow.loss), QString::number(group.count),
               QString::number(group.worst.front().line)});
  }
  return table.empty() ? QString()
                       : table.html() + small(ReportWords::tr("Share: of all the time that is lost along the "
                                                              "path against the programmed feed."));
}

QString time_changes_block(const ReportInput& input) {
  const ChangeTrials& trials = input.time->changes;
  if (trials.tried.empty()) {
    return {};
  }
  if (trials.best.empty()) {
    return paragraph(
        ReportWords::tr("None of the %1 changes that were simulated helps.").arg(trials.tried.size()));
  }
  const double now = input.time->use.cycle_time;
  HtmlTable table("lrrrr", {48, 14, 13, 11, 14});
  table.add_head({ReportWords::tr("Change"), ReportWords::tr("Cycle time [s]"), ReportWords::tr("Gain [s]"),
                  ReportWords::tr("Gain [%]"),
                  with_unit_of(ReportWords::tr("Contour error"), Dimension::error)});
  const auto add = [&](const QString& title, double time, const std::optional<double>& error) {
    table.add({title, seconds(time), fixed(now - time, decimals_of_gain(now - time)),
               percent(now - time, now), error ? error_number(*error) : QStringLiteral("–")});
  };
  table.add({ReportWords::tr("As it is"), seconds(now), QStringLiteral("–"), QStringLiteral("–"),
             error_number(input.run().shown->run.summary.cutting_contour_error)});
  for (const std::size_t i : trials.best) {
    add(change_title(input, trials.tried[i]), trials.tried[i].cycle_time,
        trials.tried[i].cutting_contour_error);
  }
  if (trials.together) {
    add(ReportWords::tr("Those of this machine together"), trials.together->cycle_time,
        trials.together->cutting_contour_error);
  }
  return table.html() +
         small(
             ReportWords::tr("The best of %1 changes of the whole program, each simulated. Whether machine, "
                             "tool and material bear it is not checked.")
                 .arg(trials.tried.size()));
}

}  // namespace feedscope::ui
