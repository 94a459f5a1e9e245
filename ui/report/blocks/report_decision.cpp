#include "ui/report/blocks/report_decision.h"

#include <QApplication>
#include <QPainter>
#include <QPen>
#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/study/recommendation.h"
#include "core/analysis/time/time_report.h"
#include "ui/decide/decision_chart.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/remedy_text.h"
#include "ui/language/texts.h"
#include "ui/language/time_texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/blocks/cause_bars.h"
#include "ui/report/blocks/report_cards.h"
#include "ui/report/pictures.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/workbench/decision.h"
#include "ui/workbench/reading_faults.h"

namespace feedscope::ui {

namespace {

constexpr int half_share = 49;      // [%]
constexpr double half_width = 326;  // of two columns [1/96 inch]
constexpr double decision_height = 176;
constexpr QSizeF corner_size(226, 190);
const QString taken_ground = QStringLiteral("#fdeee0");

std::optional<Recommendation> recommendation(const ReportInput& input) {
  return recommend(run_figures(input), input.within);
}

bool has_drives(const ReportInput& input) {
  return std::ranges::any_of(input.runs,
                             [](const ReportRun& run) { return summary_of(run).actual.has_value(); });
}

bool moves(const ReportRun& run) {
  return !is_refused(run.shown->run) && summary_of(run).cycle_time > 0;
}

Decision decision_of(const ReportInput& input) {
  const QStringList names = short_names(input);
  QStringList lettered;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    lettered.append(QStringLiteral("%1 (%2)").arg(run_letter(i), names[static_cast<qsizetype>(i)]));
  }
  return DecisionTexts::decision(run_figures(input), lettered, input.within);
}

QString fault(const QString& html) {
  return QStringLiteral("<p class=\"fault\">%1</p>\n").arg(html);
}

QString message_text(const Diagnostic& message) {
  const QString text = html_text(in_language(message.message));
  return message.line == 0 ? text : ReportWords::tr("Line %1: %2").arg(message.line).arg(text);
}

/// The first error, else the first warning.
const Diagnostic* first_fault(const std::vector<Diagnostic>& messages) {
  for (const Severity severity : {Severity::error, Severity::warning}) {
    const auto found = std::ranges::find(messages, severity, &Diagnostic::severity);
    if (found != messages.end()) {
      return &*found;
    }
  }
  return nullptr;
}

QString reading_fault(const ReportInput& input) {
  const Program& program = *input.program().program;
  const Diagnostic* first = first_fault(program.diagnostics);
  return first == nullptr
             ? QString()
             : fault(QStringLiteral("<b>%1.</b> %2")
                         .arg(reading_faults_text(program).toHtmlEscaped(), message_text(*first)));
}

/// Parts of the program that the machine or the control cannot run; no sentence twice, with the letters of
/// its runs unless it is about all.
QString run_faults(const ReportInput& input) {
  std::vector<std::pair<QString, QStringList>> texts;
  for (std::size_t row = 0; row < input.runs.size(); ++row) {
    const auto add = [&](const QString& text) {
      auto known = std::ranges::find(texts, text, &std::pair<QString, QStringList>::first);
      known = known != texts.end() ? known : texts.insert(known, {text, {}});
      known->second.append(run_letter(row));
    };
    const Run& run = input.runs[row].shown->run;
    if (const Diagnostic* first = first_fault(run.path.faults)) {
      add(message_text(*first));
    }
    for (const Message& text : texts_about(remarks(run), {Remark::About::validity})) {
      add(html_text(in_language(text)));
    }
  }
  QString html;
  for (const auto& [text, letters] : texts) {
    html += fault(letters.size() == static_cast<qsizetype>(input.runs.size())
                      ? text
                      : QStringLiteral("<b>%1</b> – %2").arg(letters.join(QStringLiteral(", ")), text));
  }
  return html;
}

/// Whether a single run keeps the bound.
QString bound_sentence(const ReportInput& input) {
  if (!input.within || !moves(input.run())) {
    return {};
  }
  const QString bound = amount_text(*input.within, Dimension::error);
  return keeps_bound(deciding_error(summary_of(input.run())), input.within)
             ? ReportWords::tr("The contour error keeps the bound of %1.").arg(bound)
             : ReportWords::tr("The contour error is above the bound of %1.").arg(bound);
}

/// Notes that pictures and places are not those of the recommended run.
QString shown_run_sentence(const ReportInput& input) {
  const auto leading = leading_run(run_figures(input), input.within);
  return !leading || *leading == input.current
             ? QString()
             : ReportWords::tr(
                   "Pictures and places are those of %1, which the recordings or the range belong to.")
                   .arg(lettered_name(input, input.current));
}

QString unmade_runs(const ReportInput& input) {
  QString html;
  for (const UnmadeRun& run : input.unmade) {
    html += fault(ReportWords::tr("<b>%1 could not be simulated.</b> %2")
                      .arg(html_text(run.name), html_text(in_language(run.why))));
  }
  return html;
}

/// Note that several tolerances were requested, but some models have one run for all of them.
QString unused_tolerances(const ReportInput& input) {
  std::set<QString> models;
  for (const ReportRun& run : input.runs) {
    if (input.tolerances_asked > 0 && !contour_tolerance(run.shown->run.setup)) {
      models.insert(QString::fromStdString(run.shown->run.setup.model->info().id));
    }
  }
  QString html;
  for (const QString& model : models) {
    html += fault(
        input.tolerances_asked == 1
            ? ReportWords::tr("The model %1 uses no contour tolerance.").arg(html_text(model))
            : ReportWords::tr("The model %1 uses no contour tolerance: it has one run for the %2 that were "
                              "asked for.")
                  .arg(html_text(model))
                  .arg(input.tolerances_asked));
  }
  return html;
}

/// A sample of a run's line.
QString line_sample(const ReportInput& input, std::size_t row, ReportPictures& pictures) {
  static constexpr QSizeF size(34, 8);
  QPen pen(input.runs[row].colour, 2);
  pen.setCapStyle(Qt::FlatCap);
  if (const QList<qreal> dashes = run_dashes(row); !dashes.isEmpty()) {
    pen.setDashPattern(dashes);
  }
  return pictures.add(QStringLiteral("line%1").arg(row),
                      {size, false,
                       [pen](QPainter& painter, double) {
                         painter.setPen(pen);
                         painter.drawLine(QPointF(0, size.height() / 2),
                                          QPointF(size.width(), size.height() / 2));
                       }},
                      ReportWords::tr("Line of %1").arg(run_letter(row)));
}

std::size_t refused_lines(const ReportRun& run) {
  return run.shown->run.lines_not_run.size();
}

QString decision_chart(const ReportInput& input, ReportPictures& pictures) {
  const auto taken = recommendation(input);
  std::size_t least_refused = std::numeric_limits<std::size_t>::max();  // the others run less
  for (const ReportRun& run : input.runs) {
    least_refused = moves(run) ? std::min(least_refused, refused_lines(run)) : least_refused;
  }
  std::vector<DecisionDot> dots;
  for (std::size_t row = 0; row < input.runs.size(); ++row) {
    if (moves(input.runs[row]) && refused_lines(input.runs[row]) == least_refused) {
      const Summary& summary = summary_of(input.runs[row]);
      dots.push_back({row, summary.cycle_time, deciding_error(summary), run_letter(row),
                      input.runs[row].colour, taken && taken->run == row, taken && taken->run == row,
                      summary.actual.has_value()});
    }
  }
  if (dots.size() < 2) {
    return {};
  }
  auto chart = std::make_shared<DecisionChart>();
  chart->set(std::move(dots), input.within);
  chart->ensurePolished();
  chart->resize(QSizeF(half_width, decision_height).toSize());
  return pictures.add(QStringLiteral("decision"),
                      {QSizeF(half_width, decision_height), false,
                       [chart](QPainter& painter, double) { chart->draw(painter); }},
                      ReportWords::tr("Cycle time over contour error of each run"));
}

QString title_line(const QString& text) {
  return QStringLiteral("<p class=\"figure-title\">%1</p>\n").arg(text);
}

/// A title and the bars below it.
std::pair<QString, QString> cause_bars(const ReportInput& input, double width, ReportPictures& pictures) {
  const auto bars = std::make_shared<const CauseBars>(comparison_bars(run_figures(input)), width);
  const QString title = ReportWords::tr("What limits the feed");
  return {title_line(bars->on_the_clock() ? title : QStringLiteral("%1 [s]").arg(title)),
          pictures.add(QStringLiteral("causes_of_runs"),
                       {bars->size(), false, [bars](QPainter& painter, double) { bars->paint(painter); }},
                       ReportWords::tr("Cycle time of each run by limiting cause"))};
}

/// A picture without a caption; alone in a cell it has no space above.
QString framed(const QString& picture) {
  return QStringLiteral(
             "<table class=\"frame\" width=\"100%\" cellspacing=\"0\" cellpadding=\"0\"><tr><td>%1</td></tr>"
             "</table>\n")
      .arg(picture);
}

/// Where the lens shows what the tolerance does: the largest error of feed motions, else a corner that loses
/// time [s].
std::optional<double> worst_corner(const ReportInput& input) {
  const Run& run = input.run().shown->run;
  const ContourPlace& worst = run.summary.worst_place;
  if (worst.error > 0 && run.summary.cutting_contour_error >= worst.error) {
    return worst.time;
  }
  for (const SlowGroup& group : input.time->slow.groups) {
    if (group.shape == PlaceShape::corner) {
      return group.worst.front().slowest;
    }
  }
  return std::nullopt;
}

QString corner_figure(const ReportInput& input, ReportPictures& pictures) {
  const std::optional<double> time = worst_corner(input);
  if (!time) {
    return {};
  }
  const auto shot = std::make_shared<const LensShot>(lens_shot(input, *time));
  if (!shot->lens.deviates) {  // the lens omits the drives' deviation from the set path
    return {};
  }
  const QString picture = pictures.add(QStringLiteral("corner"), lens_picture(shot, corner_size),
                                       ReportWords::tr("Lens at line %1").arg(shot->lens.line));
  if (has_drives(input)) {
    return figure(picture,
                  ReportWords::tr("Largest contour error of the set path, line %1; the actual one, with the "
                                  "drives, is in the table.")
                      .arg(shot->lens.line));
  }
  return figure(picture, input.runs.size() > 1
                             ? ReportWords::tr("Largest contour error of %1, line %2, all runs.")
                                   .arg(lettered_name(input, input.current))
                                   .arg(shot->lens.line)
                             : ReportWords::tr("Largest contour error, line %1.").arg(shot->lens.line));
}

QString group_place(const SlowGroup& group) {
  const QString shape = core_text(std::string(info_of(group.shape).title));
  const QString line = QString::number(group.worst.front().line);
  return group.count > 1 ? ReportWords::tr("%1, line %2 and %3 more")
                               .arg(shape, line, QLocale().toString(static_cast<qulonglong>(group.count - 1)))
                         : ReportWords::tr("%1, line %2").arg(shape, line);
}

QString loss_table(const ReportInput& input) {
  constexpr std::size_t most = 4;
  constexpr double worth_a_row = 1e-3;  // of the cycle time
  HtmlTable table("llr", {44, 40, 16});
  table.add_head({ReportWords::tr("Place"), ReportWords::tr("Why"), ReportWords::tr("Lost")});
  std::size_t rows = 0;
  for (const SlowGroup& group : input.time->slow.groups) {
    if (rows < most && group.loss >= worth_a_row * input.time->use.cycle_time) {
      table.add({html_text(group_place(group)) + figure_reference(card_picture_of(*input.time, group)),
                 html_text(TimeTexts::lost_to(group)), TimeTexts::gain(group.loss)});
      ++rows;
    }
  }
  return table.empty() ? QString() : table.html();
}

QString help_table(const ReportInput& input) {
  const ChangeTrials& trials = input.time->changes;
  if (trials.tried.empty()) {
    return {};
  }
  if (trials.best.empty()) {
    return paragraph(
        ReportWords::tr("None of the %1 changes that were simulated helps.").arg(trials.tried.size()));
  }
  const bool with_error = !has_drives(input);  // the actual error after a change is unknown
  HtmlTable table(with_error ? "lrr" : "lr", with_error ? std::vector{58, 18, 24} : std::vector{76, 24});
  QStringList head{ReportWords::tr("What would help"), ReportWords::tr("Gain")};
  if (with_error) {
    head.append(with_unit_of(ReportWords::tr("Contour error"), Dimension::error));
  }
  table.add_head(head);
  for (const std::size_t i : trials.best) {
    const TriedChange& change = trials.tried[i];
    QStringList row{html_text(remedy_text(change.remedy, input.run().shown->run.setup)),
                    TimeTexts::gain(input.time->use.cycle_time - change.cycle_time)};
    if (with_error) {
      row.append(change.cutting_contour_error ? error_number(*change.cutting_contour_error)
                                              : QStringLiteral("–"));
    }
    table.add(row);
  }
  return table.html();
}

}  // namespace

QString lettered_name(const ReportInput& input, std::size_t run) {
  const QString name = html_text(short_names(input)[static_cast<qsizetype>(run)]);
  return input.runs.size() > 1 ? QStringLiteral("%1 (%2)").arg(run_letter(run), name) : name;
}

QString subject_block(const ReportInput& input) {
  QStringList parts;
  if (!input.title.isEmpty()) {
    parts.append(input.title);
  }
  parts.append(program_file_name(*input.program().program));
  std::set<std::string> machines;
  for (const ReportRun& run : input.runs) {
    machines.insert(run.shown->run.setup.machine.name);
  }
  if (machines.size() == 1) {
    parts.append(QString::fromStdString(*machines.begin()));
  }
  parts.append(common_name(input));
  parts.append(input.author);
  parts.removeAll(QString());
  return html_text(parts.join(QStringLiteral(" · ")));
}

QString headline_block(const ReportInput& input) {
  const bool stands = std::ranges::none_of(input.runs, [](const ReportRun& run) {
    return is_refused(run.shown->run) || summary_of(run).cycle_time > 0;
  });
  if (stands) {
    return ReportWords::tr("No motion in this program: there is no time to report.");
  }
  if (input.runs.size() > 1) {
    return html_text(decision_of(input).headline);
  }
  return moves(input.run())
             ? html_text(DecisionTexts::single(summary_of(input.run())))
             : ReportWords::tr("The control refuses the program: none of its feed motions is run.");
}

QString verdict_block(const ReportInput& input) {
  QStringList sentences{input.runs.size() > 1 ? html_text(decision_of(input).rule) : bound_sentence(input),
                        shown_run_sentence(input)};
  sentences.removeAll(QString());
  const QString rule = sentences.join(' ');
  const QString why = rule.isEmpty() ? QString() : QStringLiteral("<p class=\"rule\">%1</p>\n").arg(rule);
  return why + unmade_runs(input) + reading_fault(input) + run_faults(input) + unused_tolerances(input);
}

QString decision_charts_block(const ReportInput& input, ReportPictures& pictures) {
  if (!std::ranges::any_of(input.runs, moves)) {
    return {};
  }
  const QString chart = decision_chart(input, pictures);
  const auto [title, bars] = cause_bars(input, chart.isEmpty() ? report_width : half_width, pictures);
  if (chart.isEmpty()) {
    return title + QStringLiteral("<p>%1</p>\n").arg(bars);
  }
  return two_columns(title_line(has_drives(input) ? ReportWords::tr("Cycle time over actual contour error")
                                                  : ReportWords::tr("Cycle time over contour error")) +
                         framed(chart),
                     title + framed(bars), half_share);
}

QString runs_table_block(const ReportInput& input, ReportPictures& pictures) {
  const bool several = input.runs.size() > 1;
  const auto taken = several ? recommendation(input) : std::nullopt;
  const std::size_t against = taken ? taken->against : 0;
  const QStringList names = short_names(input);
  HtmlTable table("llrrrrr", {several ? 12 : 36, several ? 26 : 2, 13, 13, 13, 10, 13});
  QStringList head{several ? ReportWords::tr("Run") : QString(),
                   QString(),
                   ReportWords::tr("Cycle time"),
                   several ? ReportWords::tr("Against %1").arg(run_letter(against)) : QString(),
                   with_unit_of(has_drives(input) ? ReportWords::tr("Actual contour error")
                                                  : ReportWords::tr("Contour error"),
                                Dimension::error),
                   ReportWords::tr("Corner blends"),
                   with_unit_of(ReportWords::tr("Mean feed with rapids"), Dimension::feed)};
  head.replaceInStrings(QStringLiteral(" ["), QStringLiteral("<br/>["));  // else "mm/min" would break
  table.add_head(head);
  for (std::size_t row = 0; row < input.runs.size(); ++row) {
    const ReportRun& run = input.runs[row];
    const Summary& summary = summary_of(run);
    QStringList cells{html_text(names[static_cast<qsizetype>(row)])};
    several ? cells.prepend(run_letter(row) + "&nbsp; " + line_sample(input, row, pictures))
            : cells.append(QString());
    if (is_refused(run.shown->run)) {
      cells << ReportWords::tr("refused") << QStringLiteral("–") << QStringLiteral("–") << QStringLiteral("–")
            << QStringLiteral("–");
    } else {
      cells << clock_text(summary.cycle_time)
            << (several ? DecisionTexts::against(run.shown->run, input.runs[against].shown->run) : QString())
            << error_number(deciding_error(summary))
            << QString::number(run.shown->run.trajectory->blend_count())
            << fixed(summary.mean_feed, Dimension::feed);
    }
    const bool chosen = taken && taken->run == row;
    for (QString& cell : cells) {
      cell = chosen ? QStringLiteral("<b>%1</b>").arg(cell) : cell;
    }
    table.add(cells, chosen ? taken_ground : QString());
  }
  return table.html();
}

QString path_block(const ReportInput& input, ReportPictures& pictures) {
  const Run& run = input.run().shown->run;
  if (run.trajectory->pieces().empty()) {
    return {};
  }
  const QString name = lettered_name(input, input.current);
  const bool several = input.runs.size() > 1;
  QString caption =
      input.scene.colouring == Colouring::feed
          ? (several ? ReportWords::tr("Executed path of %1, coloured by its feed.").arg(name)
                     : ReportWords::tr("Executed path, coloured by its feed."))
          : (several ? ReportWords::tr("Executed path of %1.").arg(name) : ReportWords::tr("Executed path."));
  for (const Message& text : texts_about(remarks(run), {Remark::About::not_counted})) {
    caption += ' ' + html_text(in_language(text));
  }
  return elastic_view(without_other_runs(input), pictures, caption);
}

QString losses_block(const ReportInput& input, ReportPictures& pictures) {
  if (!moves(input.run())) {
    return {};
  }
  const QString losses = loss_table(input);
  const QString title =
      input.runs.size() > 1
          ? ReportWords::tr("Where %1 still loses time").arg(lettered_name(input, input.current))
          : ReportWords::tr("Where time is lost");
  const QString tables = (losses.isEmpty() ? QString() : title_line(title) + losses) + help_table(input);
  const QString corner = corner_figure(input, pictures);
  return corner.isEmpty() ? tables : two_columns(corner, tables, narrow_share);
}

}  // namespace feedscope::ui
