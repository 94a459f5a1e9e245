#include "ui/report/blocks/report_identification.h"

#include <QDate>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "core/identification/recordings.h"
#include "ui/identification/identification_texts.h"
#include "ui/identification/residual_plot.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t most_recording_plots = 4;
constexpr std::size_t most_section_rows = 5;

const Identification& chosen_of(const IdentificationResult& result) {
  return result.outcome->models[result.chosen];
}

QString recordings_table(const IdentificationOutcome& outcome, const Identification& found) {
  HtmlTable table("llrrrr", {28, 12, 14, 14, 13, 19});
  table.add_head({ReportWords::tr("Recording"), ReportWords::tr("Kind"), ReportWords::tr("Recorded time"),
                  ReportWords::tr("Simulated time"), ReportWords::tr("Difference [%]"),
                  with_unit_of(ReportWords::tr("Feeds (rms)"), Dimension::feed)});
  for (std::size_t i = 0; i < outcome.recordings.size(); ++i) {
    const UsedRecording& recording = outcome.recordings[i];
    const Agreement& agreement = found.agreements[i];
    table.add({html_text(recording.name),
               recording.is_table ? ReportWords::tr("section times") : ReportWords::tr("trace"),
               clock_text(agreement.measured_time), clock_text(agreement.simulated_time),
               IdentificationTexts::time_error(agreement),
               recording.is_table ? QStringLiteral("–") : fixed(agreement.feed_rms, Dimension::feed)});
  }
  return table.html();
}

QString models_table(const IdentificationOutcome& outcome) {
  if (outcome.models.size() + outcome.unfitted.size() < 2) {
    return {};
  }
  HtmlTable table("lrrrr", {40, 13, 14, 14, 19});
  table.add_head({ReportWords::tr("Control model"), ReportWords::tr("Residual"),
                  ReportWords::tr("Feed error [%]"), ReportWords::tr("Time error [%]"),
                  ReportWords::tr("Explains the recordings")});
  for (const Identification& found : outcome.models) {
    const auto worst = std::ranges::max_element(
        found.agreements, {}, [](const Agreement& agreement) { return std::abs(agreement.time_error()); });
    table.add({html_text(core_text(found.setup.model->info().title)), fixed(found.residual, 2),
               percent(found.feed_error, 2), IdentificationTexts::time_error(*worst),
               explains_roughly(found, outcome.models.front()) ? ReportWords::tr("roughly")
               : found.explains                                ? ReportWords::tr("yes")
                                                               : ReportWords::tr("no")});
  }
  QString reasons;
  for (const UnfittedModel& unfitted : outcome.unfitted) {
    const QString title = html_text(core_text(unfitted.title));
    table.add({title, QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–"),
               ReportWords::tr("not fitted")});
    reasons +=
        caption_paragraph(ReportWords::tr("%1: %2").arg(title, html_text(in_language(unfitted.reason))));
  }
  return table.html() + reasons;
}

/// Source of a number, or the reason why it is not identifiable.
QString source_of(const IdentifiedParameter& one, const IdentificationOutcome& outcome, bool explains) {
  const QDate date = QDate::fromString(QString::fromStdString(outcome.date), Qt::ISODate);
  return one.told ? ReportWords::tr("identified from %1, %2")
                        .arg(IdentificationTexts::names(outcome), date_text(date.startOfDay()))
                  : IdentificationTexts::explanation(one, explains);
}

QString numbers_table(const IdentificationOutcome& outcome, const Identification& found) {
  HtmlTable table("llrrrl", {22, 8, 10, 15, 10, 35});
  table.add_head({ReportWords::tr("Limit or setting"), ReportWords::tr("Unit"), ReportWords::tr("Begun with"),
                  ReportWords::tr("Found"), ReportWords::tr("± (95 %)"),
                  ReportWords::tr("Source, or why it was not found")});
  for (const IdentifiedParameter& one : found.parameters) {
    const QString value = IdentificationTexts::found_value(one);
    table.add({html_text(setting_title(one.parameter.key)), html_text(key_unit(one.parameter.unit).text),
               IdentificationTexts::value(one.start, one.parameter),
               one.told ? QStringLiteral("<b>%1</b>").arg(value) : value,
               IdentificationTexts::uncertainty(one), html_text(source_of(one, outcome, found.explains))});
  }
  return table.html();
}

/// Of each table, the sections with the largest deviation of the model.
QString sections_tables(const IdentificationOutcome& outcome, const Identification& found) {
  QString html;
  for (std::size_t i = 0; i < outcome.recordings.size(); ++i) {
    std::vector<SectionAgreement> worst = found.sections[i];
    if (worst.empty()) {
      continue;
    }
    const std::size_t all = worst.size();
    std::ranges::stable_sort(worst, std::ranges::greater(), [](const SectionAgreement& one) {
      return std::abs(one.simulated_time - one.measured_time);
    });
    worst.resize(std::min(all, most_section_rows));
    HtmlTable table("lrrr", {40, 20, 20, 20});
    table.add_head({ReportWords::tr("Section"), with_unit_of(ReportWords::tr("Recorded"), Dimension::time),
                    with_unit_of(ReportWords::tr("Simulated"), Dimension::time),
                    with_unit_of(ReportWords::tr("Difference"), Dimension::time)});
    for (const SectionAgreement& one : worst) {
      table.add({html_text(one.section), fixed(one.measured_time, Dimension::time, 4),
                 fixed(one.simulated_time, Dimension::time, 4),
                 fixed(one.simulated_time - one.measured_time, Dimension::time, 4)});
    }
    html += table.html() + caption_paragraph(ReportWords::tr("%1: the %2 of %3 sections that differ most.")
                                                 .arg(html_text(outcome.recordings[i].name))
                                                 .arg(worst.size())
                                                 .arg(all));
  }
  return html;
}

/// Whether a searched file now contains another trace. Traces that the report does not show are ignored.
bool has_another_recording(const std::vector<ReportTrace>& traces, const IdentificationOutcome& outcome) {
  std::vector<UsedRecording> now;
  for (const ReportTrace& trace : traces) {
    now.push_back(used_recording(*trace.shown->trace));
  }
  return std::ranges::any_of(outcome.recordings, [&](const UsedRecording& used) {
    return !used.is_table && std::ranges::find(now, used.name, &UsedRecording::name) != now.end() &&
           std::ranges::find(now, used) == now.end();
  });
}

QString paragraphs_of(const QString& text) {
  QString html;
  for (const QString& line : text.split('\n', Qt::SkipEmptyParts)) {
    html += paragraph(html_text(line));
  }
  return html;
}

}  // namespace

QString identification_block(const ReportInput& input) {
  const IdentificationResult& result = input.identification;
  if (result.outcome == nullptr) {
    return {};
  }
  const IdentificationOutcome& outcome = *result.outcome;
  const Identification& found = chosen_of(result);
  QString html;
  if (result.stale || outcome.program != program_mark(input.program()) ||
      has_another_recording(input.traces, outcome)) {
    html += QStringLiteral("<p><b>%1</b></p>\n")
                .arg(ReportWords::tr("Program, recordings, models or machine have changed since."));
  }
  html += paragraph(html_text(IdentificationTexts::judgement(found)) + ' ' +
                    ReportWords::tr("The search began with the machine %1.")
                        .arg(html_text(QString::fromStdString(found.setup.machine.name))));
  html += recordings_table(outcome, found);
  html += models_table(outcome);
  html += caption_paragraph(
      ReportWords::tr("Residual of %1: %2, root mean square of what it leaves over; 1 is noise and sampling "
                      "alone. A model explains the recordings if it is within 5 % of the feed and 1 % of the "
                      "time.")
          .arg(html_text(core_text(found.setup.model->info().title)), fixed(found.residual, 2)));
  html += numbers_table(outcome, found);
  html += paragraphs_of(IdentificationTexts::drives(found).join('\n'));
  if (found.explains) {
    html += paragraphs_of(IdentificationTexts::summary(found));
  }
  return html + sections_tables(outcome, found);
}

QString identification_charts_block(const ReportInput& input, ReportPictures& pictures) {
  const IdentificationResult& result = input.identification;
  if (result.outcome == nullptr) {
    return {};
  }
  constexpr double plot_height = 170;
  constexpr double legend_height = 16;  // per model
  const auto curves =
      std::make_shared<std::vector<ResidualCurves>>(residual_curves(*result.outcome, result.chosen));
  const std::size_t all = curves->size();
  curves->resize(std::min(all, most_recording_plots));
  const std::size_t models = result.outcome->models.size();
  const double height = plot_height + (models > 1 ? legend_height * static_cast<double>(models) : 0);
  const QSizeF size(report_width, height * static_cast<double>(curves->size()));
  const auto paint = [curves, height](QPainter& painter, double) {
    const ThemeColours colours = theme_colours(QPalette(Qt::white));
    for (std::size_t i = 0; i < curves->size(); ++i) {
      const QRectF area(0, static_cast<double>(i) * height, report_width, height);
      ResidualPlot((*curves)[i], area, paper_font(10), colours).draw(painter);
    }
  };
  QString caption = ReportWords::tr(
      "What is left over: how far the simulation is behind the recording as it goes on, or what it is longer "
      "in each section. A level curve: feed and time agree there.");
  if (curves->size() < all) {
    caption += ' ' + ReportWords::tr("The first %1 of %2 recordings.").arg(curves->size()).arg(all);
  }
  return figure(pictures.add(QStringLiteral("identification"), {size, false, paint},
                             ReportWords::tr("Residuals of the identification")),
                caption);
}

}  // namespace feedscope::ui
