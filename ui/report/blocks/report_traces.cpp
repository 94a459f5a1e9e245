#include "ui/report/blocks/report_traces.h"

#include <QStandardItemModel>

#include "ui/paper/html_table.h"
#include "ui/trace/trace_tables.h"

namespace feedscope::ui {

namespace {

QString part_of(const ReportTrace& trace) {
  QStandardItemModel figures;
  fill_figures(figures, *trace.shown);
  QStandardItemModel places;
  fill_worst_places(places, *trace.shown);
  QString html = QStringLiteral("<h3><span style=\"color:%1\">■</span> %2</h3>\n<p>%3</p>\n")
                     .arg(trace.colour.name(), html_text(trace.name), html_text(verdict_of(*trace.shown)));
  html += html_of_model(figures, {40, 20, 20, 20});
  if (places.rowCount() > 0) {
    html += html_of_model(places, {25, 25, 25, 25});
  }
  return html + caption_paragraph(html_text(remarks_of(*trace.shown).join(QLatin1Char(' '))));
}

}  // namespace

QString traces_block(const ReportInput& input) {
  QString html;
  for (const ReportTrace& trace : input.traces) {
    html += part_of(trace);
  }
  return html;
}

}  // namespace feedscope::ui
