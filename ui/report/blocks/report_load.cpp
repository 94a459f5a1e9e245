#include "ui/report/blocks/report_load.h"

#include <algorithm>

#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/load/load_texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t max_place_rows = 12;

QString operations_table(const RunLoad& load, const LoadFigures& figures) {
  HtmlTable table("rllrrrrllr", {4, 18, 22, 8, 6, 6, 7, 7, 12, 10});
  table.add_head({ReportWords::tr("No."), ReportWords::tr("Operation"), ReportWords::tr("Material"),
                  with_unit_of(ReportWords::tr("Diameter"), Dimension::length), ReportWords::tr("Teeth"),
                  with_unit_of(ReportWords::tr("Helix"), Dimension::angle),
                  with_unit_of(QStringLiteral("a<sub>e</sub>"), Dimension::length),
                  with_unit_of(QStringLiteral("a<sub>p</sub>"), Dimension::length),
                  ReportWords::tr("Milling"),
                  with_unit_of(ReportWords::tr("Cutting time"), Dimension::time)});
  const auto& operations = load.model().operations();
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const Engagement& operation = operations[i].operation;
    table.add({QString::number(i + 1), html_text(operation_text(operation)),
               html_text(core_text(operations[i].material.title)),
               fixed(operation.diameter, Dimension::length), QString::number(operation.teeth),
               fixed(operation.helix, Dimension::angle, 1), fixed(operation.radial_depth, Dimension::length),
               fixed(operation.axial_depth, Dimension::length),
               operation.milling == Milling::up ? ReportWords::tr("up") : ReportWords::tr("down"),
               fixed(figures.operations[i].cutting_time, Dimension::time)});
  }
  return table.html();
}

QString with_unit(double value, Dimension dimension) {
  return QStringLiteral("%1 %2").arg(fixed(value, dimension), unit_of(dimension));
}

QString figures_table(const LoadTotals& totals) {
  HtmlTable table("lrrrrr");
  table.add_group_head({{QString(), 1},
                        {ReportWords::tr("At the predicted feed"), 3},
                        {ReportWords::tr("At the programmed feed"), 2}});
  table.add_head({ReportWords::tr("Load"), ReportWords::tr("largest"), ReportWords::tr("in line"),
                  ReportWords::tr("mean"), ReportWords::tr("largest"), ReportWords::tr("mean")});
  for (std::size_t i = 0; i < load_quantity_count; ++i) {
    const QuantityInfo& info = info_of(load_quantities()[i].id);
    const LoadFigure& predicted = totals.predicted[i];
    const LoadFigure& programmed = totals.programmed[i];
    table.add({html_text(core_text(std::string(info.title))), with_unit(predicted.largest, info.dimension),
               QString::number(predicted.line), with_unit(predicted.mean, info.dimension),
               with_unit(programmed.largest, info.dimension), with_unit(programmed.mean, info.dimension)});
  }
  return table.html();
}

QString places_table(const LoadFigures& load) {
  struct Row {
    LoadLimit limit;
    LoadPlace place;
  };
  std::vector<Row> rows;
  std::size_t count = 0;
  for (const LimitFigures& limit : load.limits) {
    count += limit.count;
    for (const LoadPlace& place : limit.places) {
      rows.push_back({limit.limit, place});
    }
  }
  std::ranges::stable_sort(rows, std::ranges::greater(),
                           [](const Row& row) { return row.place.to - row.place.from; });
  if (rows.empty()) {
    return {};
  }
  HtmlTable table("llrrr");
  table.add_head({ReportWords::tr("Beyond a bound"), ReportWords::tr("Lines"), ReportWords::tr("worst"),
                  with_unit_of(ReportWords::tr("from"), Dimension::time),
                  with_unit_of(ReportWords::tr("for"), Dimension::time)});
  for (std::size_t i = 0; i < std::min(rows.size(), max_place_rows); ++i) {
    const auto& [limit, place] = rows[i];
    const QString lines = place.first_line == place.last_line
                              ? QString::number(place.first_line)
                              : QStringLiteral("%1–%2").arg(place.first_line).arg(place.last_line);
    table.add({html_text(limit_text(limit)), lines,
               with_unit(place.worst, info_of(load_quantities()[quantity_of(limit)].id).dimension),
               fixed(place.from, Dimension::time), fixed(place.to - place.from, Dimension::time)});
  }
  QString html = table.html();
  if (count > max_place_rows) {
    html += caption_paragraph(ReportWords::tr("The %1 longest of %2 places.").arg(max_place_rows).arg(count));
  }
  return html;
}

}  // namespace

QString load_block(const ReportInput& input) {
  const Run& run = input.run().shown->run;
  if (!run.summary.load || run.sources.load == nullptr) {
    return {};
  }
  const LoadFigures& load = *run.summary.load;
  QString html = operations_table(*run.sources.load, load);
  if (load.all.cutting_time > 0) {
    html += figures_table(load.all);
  }
  for (const QString& sentence : limits_text(load)) {
    html += paragraph(html_text(sentence) + '.');
  }
  html += places_table(load);
  html += caption_paragraph(html_text(assumptions_text(load)));
  if (const QString without = without_load_text(load); !without.isEmpty()) {
    html += caption_paragraph(html_text(without));
  }
  for (const LoadedOperation& operation : run.sources.load->model().operations()) {
    const QString source = ReportWords::tr("%1: %2.").arg(html_text(core_text(operation.material.title)),
                                                          html_text(operation.material.source));
    if (!html.contains(source)) {
      html += caption_paragraph(source);
    }
  }
  return html;
}

QString load_view_block(const ReportInput& input, ReportPictures& pictures) {
  if (!input.run().shown->run.sources.load) {
    return {};
  }
  return coloured_view(input, Colouring::chip_thickness, QStringLiteral("chip_thickness"),
                       ReportWords::tr("3D view by chip thickness"),
                       ReportWords::tr("Chip thickness of %1 along the path; grey: no load is computed.")
                           .arg(html_text(input.run().name)),
                       pictures);
}

}  // namespace feedscope::ui
