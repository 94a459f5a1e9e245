#include <algorithm>

#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

namespace {

QString list_of(const std::vector<Message>& items) {
  QString html;
  for (const Message& item : items) {
    html += QStringLiteral("<li>%1</li>\n").arg(html_text(in_language(item)));
  }
  return html.isEmpty() ? html : QStringLiteral("<ul>\n%1</ul>\n").arg(html);
}

/// Heading of a list.
QString lead(const QString& text) {
  return QStringLiteral("<p class=\"lead\"><b>%1</b></p>\n").arg(text);
}

/// Names of the runs of one model with equal guarantees.
struct Promise {
  std::vector<Message> sentences;
  QStringList runs;
};

std::vector<Promise> promises_of(const ReportInput& input, const ControlModel& model) {
  std::vector<Promise> promises;
  for (const ReportRun& run : input.runs) {
    const Setup& setup = run.shown->run.setup;
    if (setup.model != &model) {
      continue;
    }
    std::vector<Message> said = sentences(model.guarantees(setup.settings));
    const auto same = std::ranges::find(promises, said, &Promise::sentences);
    if (same != promises.end()) {
      same->runs.append(run.name);
    } else {
      promises.push_back({std::move(said), {run.name}});
    }
  }
  return promises;
}

QString model_text(const ReportInput& input, const ControlModel& model) {
  const ModelInfo& info = model.info();
  QString html =
      QStringLiteral("<h3>%1 (%2)</h3>\n<p>%3</p>\n")
          .arg(html_text(core_text(info.title)), html_text(info.id), html_text(core_text(info.summary)));
  if (!info.reference.empty()) {
    html += paragraph(ReportWords::tr("<b>Reference:</b> %1").arg(html_text(info.reference)));
  }
  const std::vector<Promise> promises = promises_of(input, model);
  for (const Promise& promise : promises) {
    const QString whose = html_text(promise.runs.join(QStringLiteral("; ")));
    html += lead(promises.size() > 1 ? ReportWords::tr("Guarantees of %1").arg(whose)
                                     : ReportWords::tr("Guarantees")) +
            list_of(promise.sentences);
  }
  if (!info.remarks.empty()) {
    html += lead(ReportWords::tr("Remarks")) + list_of(info.remarks);
  }
  return html;
}

}  // namespace

QString models_block(const ReportInput& input) {
  QString html;
  for (const ControlModel* model : all_models()) {
    const auto runs_it = [&](const ReportRun& run) { return run.shown->run.setup.model == model; };
    if (std::ranges::any_of(input.runs, runs_it)) {
      html += model_text(input, *model);
    }
  }
  return html;
}

}  // namespace feedscope::ui
