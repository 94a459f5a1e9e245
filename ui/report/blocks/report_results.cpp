#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/base/units.h"
#include "ui/charts/cause_strip.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/blocks/report_decision.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/theme/cause_colours.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {

namespace {

constexpr double min_named_share = 0.0005;  // of a cycle time; smaller shares would read 0.0 %

double against_programmed(const Summary& summary) {
  return summary.programmed_time > 0 ? summary.cycle_time / summary.programmed_time : 1;
}

QString difference_to_first(const ReportRun& run, const ReportRun& first) {
  const double of_first = summary_of(first).cycle_time;
  if (&run == &first || !(of_first > 0) || is_refused(first.shown->run)) {
    return QStringLiteral("–");
  }
  return signed_percent(summary_of(run).cycle_time / of_first - 1);
}

QString main_causes(const Summary& summary) {
  constexpr std::size_t most = 3;
  QStringList parts;
  for (const auto& [kind, time] : time_by_kind(summary)) {
    if (parts.size() < static_cast<qsizetype>(most) && time > 0.02 * summary.cycle_time) {
      parts.append(
          QStringLiteral("%1 (%2 %)").arg(cause_kind_name(kind), percent(time / summary.cycle_time, 0)));
    }
  }
  return parts.join(QStringLiteral(", "));
}

QString swatch(CauseKind kind) {
  return QStringLiteral("<span style=\"color:%1\">■</span>&nbsp;").arg(colour_of_cause(kind).name());
}

/// Causes that take time in any run, by their time in all runs together, the longest first.
std::vector<std::size_t> listed_causes(const ReportInput& input) {
  std::vector<double> shares(all_causes().size(), 0);
  for (const ReportRun& run : input.runs) {
    const Summary& summary = summary_of(run);
    const bool has_time = summary.cycle_time > 0 && !is_refused(run.shown->run);
    for (std::size_t i = 0; i < shares.size() && has_time; ++i) {
      shares[i] = std::max(shares[i], summary.time_by_cause[i] / summary.cycle_time);
    }
  }
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !(shares[i] >= min_named_share); });
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return shares[i]; });
  return order;
}

QString causes_table(const ReportInput& input, const std::vector<std::size_t>& causes, std::size_t first,
                     std::size_t end) {
  HtmlTable table("l" + [&] {
    std::string sides;
    for (std::size_t i = first; i < end; ++i) {
      sides += "rr";
    }
    return sides;
  }());
  std::vector<std::pair<QString, int>> groups{{ReportWords::tr("Limited by"), 1}};
  QStringList units{QString()};
  for (std::size_t i = first; i < end; ++i) {
    groups.emplace_back(run_label(input, i), 2);
    units << QStringLiteral("s") << QStringLiteral("%");
  }
  table.add_group_head(groups);
  table.add_head(units);
  for (const std::size_t cause : causes) {
    QStringList cells{swatch(all_causes()[cause].kind) + html_text(cause_name(all_causes()[cause]))};
    for (std::size_t i = first; i < end; ++i) {
      const Summary& summary = summary_of(input.runs[i]);
      const double time = is_refused(input.runs[i].shown->run) ? 0 : summary.time_by_cause[cause];
      cells << (time > 0 ? fixed(time, 3) : QStringLiteral("–"))
            << (time > 0 ? percent(time / summary.cycle_time, 1) : QStringLiteral("–"));
    }
    table.add(cells);
  }
  return table.html();
}

}  // namespace

QString remarks_html(const ReportInput& input) {
  std::vector<std::pair<Message, QStringList>> notes;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    for (const Remark& remark : remarks(input.runs[i].shown->run, unit_system())) {
      auto same = std::ranges::find(notes, remark.text, &std::pair<Message, QStringList>::first);
      if (same == notes.end()) {
        same = notes.insert(notes.end(), {remark.text, {}});
      }
      same->second.append(run_letter(i));
    }
  }
  QString html;
  for (const auto& [note, runs] : notes) {
    const QString said = html_text(in_language(note));
    html += QStringLiteral("<p class=\"small\">%1</p>\n")
                .arg(runs.size() == static_cast<qsizetype>(input.runs.size())
                         ? said
                         : ReportWords::tr("%1: %2").arg(runs.join(QStringLiteral(", ")), said));
  }
  return html;
}

namespace {

/// Excess of the largest distance from the programmed path in rapids over that in feed motions [mm].
double excess_in_rapids(const ReportRun& run) {
  return is_refused(run.shown->run)
             ? 0
             : summary_of(run).max_contour_error - summary_of(run).cutting_contour_error;
}

}  // namespace

std::vector<std::pair<CauseKind, double>> time_by_kind(const Summary& summary) {
  std::vector<std::pair<CauseKind, double>> kinds;
  for (std::size_t i = 0; i < summary.time_by_cause.size(); ++i) {
    const CauseKind kind = all_causes()[i].kind;
    if (kinds.empty() || kinds.back().first != kind) {
      kinds.emplace_back(kind, 0);
    }
    kinds.back().second += summary.time_by_cause[i];
  }
  std::erase_if(kinds, [](const auto& entry) { return !(entry.second > 0); });
  std::ranges::stable_sort(kinds, std::greater(), &std::pair<CauseKind, double>::second);
  return kinds;
}

QString summary_block(const ReportInput& input) {
  QString html = paragraph(headline_block(input)) + verdict_block(input);
  const QString causes =
      is_refused(input.run().shown->run) ? QString() : main_causes(summary_of(input.run()));
  if (!causes.isEmpty()) {
    html += paragraph(ReportWords::tr("Most of the time of %1 is limited by: %2.")
                          .arg(lettered_name(input, input.current), html_text(causes)));
  }
  return html + remarks_html(input);
}

QString comparison_block(const ReportInput& input) {
  HtmlTable table("lrrrrrrr", {27, 12, 10, 10, 10, 10, 11, 10});
  table.add_head({ReportWords::tr("Run"), ReportWords::tr("Cycle time [s]"),
                  ReportWords::tr("× pro-<br/>grammed"), ReportWords::tr("To first [%]"),
                  with_unit_of(ReportWords::tr("Mean feed with rapids"), Dimension::feed),
                  with_unit_of(ReportWords::tr("Peak feed"), Dimension::feed),
                  with_unit_of(ReportWords::tr("Contour error"), Dimension::error),
                  ReportWords::tr("Corner blends")});
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    const ReportRun& run = input.runs[i];
    if (is_refused(run.shown->run)) {
      table.add({run_label(input, i), QStringLiteral("<b>%1</b>").arg(ReportWords::tr("refused")),
                 QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–"),
                 QStringLiteral("–"), QStringLiteral("–")});
      continue;
    }
    const Summary& summary = summary_of(run);
    table.add({run_label(input, i), QStringLiteral("<b>%1</b>").arg(fixed(summary.cycle_time, 3)),
               summary.programmed_time > 0 ? fixed(against_programmed(summary), 3) : QStringLiteral("–"),
               difference_to_first(run, input.runs.front()), fixed(summary.mean_feed, Dimension::feed),
               fixed(summary.peak_feed, Dimension::feed), error_number(summary.cutting_contour_error),
               QString::number(run.shown->run.trajectory->blend_count())});
  }
  QString html = table.html();
  const ReportRun& in_rapids = *std::ranges::max_element(input.runs, {}, excess_in_rapids);
  if (excess_in_rapids(in_rapids) > 0) {
    html += paragraph(
        ReportWords::tr("Contour errors are those of feed motions; in rapids %1 leaves the programmed "
                        "path by up to %2.")
            .arg(html_text(in_rapids.name),
                 error_number(summary_of(in_rapids).max_contour_error) + ' ' + unit_of(Dimension::error)));
  }
  return html;
}

QString causes_block(const ReportInput& input) {
  const std::vector<std::size_t> causes = listed_causes(input);
  QString html;
  for (std::size_t first = 0; first < input.runs.size() && !causes.empty(); first += runs_a_table) {
    html += causes_table(input, causes, first, std::min(input.runs.size(), first + runs_a_table));
  }
  return html;
}

}  // namespace feedscope::ui
