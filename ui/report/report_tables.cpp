#include "ui/report/report_tables.h"

#include <QCryptographicHash>
#include <cmath>

#include "core/analysis/notes/not_counted.h"
#include "core/analysis/run/program_facts.h"
#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

constexpr qsizetype max_ranges = 40;  // of path control in the list

QString range_text(const Bounds& bounds, int axis) {
  const double from = bounds.min[axis];
  const double to = bounds.max[axis];
  return std::isfinite(from) && std::isfinite(to)
             ? ReportWords::tr("%1 to %2 %3")
                   .arg(fixed(from, Dimension::length), fixed(to, Dimension::length),
                        unit_of(Dimension::length))
             : ReportWords::tr("not programmed");
}

QString extent_text(const ProgramFacts& facts, int axis) {
  return ReportWords::tr("%1; cutting %2; rapid %3")
      .arg(range_text(facts.bounds, axis), range_text(facts.cutting_bounds, axis),
           range_text(facts.rapid_bounds, axis));
}

QString tools_text(const Program& program) {
  QStringList names;
  for (const ToolChange& tool : program.tools) {
    names.append(ReportWords::tr("%1 (line %2)").arg(html_text(tool.name)).arg(tool.line));
  }
  return names.isEmpty() ? ReportWords::tr("none programmed") : names.join(QStringLiteral(", "));
}

QString lines_text(std::uint32_t first, std::uint32_t last) {
  return first == last ? ReportWords::tr("line %1").arg(first)
                       : ReportWords::tr("lines %1 to %2").arg(first).arg(last);
}

QString path_control_text(const ProgramFacts& facts) {
  QStringList lines;
  for (const PathControlRange& range : facts.path_control) {
    if (lines.size() == max_ranges) {
      lines.append(ReportWords::tr("and %1 more").arg(facts.path_control.size() - lines.size()));
      break;
    }
    lines.append(ReportWords::tr("%1: %2").arg(lines_text(range.first_line, range.last_line),
                                               html_text(in_language(describe(range.control)))));
  }
  return lines.isEmpty() ? ReportWords::tr("as the machine") : lines.join(QStringLiteral("<br/>"));
}

QString severity_text(Severity severity) {
  return core_text(std::string(to_string(severity)));
}

}  // namespace

QString program_facts_block(const ReportInput& input) {
  const Program& program = *input.program().program;
  const ProgramFacts facts = facts_of(program, *input.runs.front().shown->run.path);
  HtmlTable table("ll", {24, 76});
  const auto add = [&](const QString& name, const QString& value) { table.add({name, value}); };
  add(ReportWords::tr("File"), html_text(program.source->name()));
  add(ReportWords::tr("Dialect"), html_text(core_text(std::string(info_of(program.dialect).title))));
  add(ReportWords::tr("Unit"), html_text(in_language(describe(program.unit))));
  add(ReportWords::tr("Size"),
      ReportWords::tr("%1 lines, %2 blocks run").arg(facts.lines).arg(program.block_count));
  add(ReportWords::tr("Segments"), ReportWords::tr("%1: %2 lines, %3 arcs, %4 dwells")
                                       .arg(facts.segments)
                                       .arg(facts.segments - facts.arcs - facts.dwells)
                                       .arg(facts.arcs)
                                       .arg(facts.dwells));
  for (int axis = 0; axis < 3; ++axis) {
    table.add({ReportWords::tr("Extent of %1").arg(QChar(coordinate_names[static_cast<std::size_t>(axis)])),
               extent_text(facts, axis)});
  }
  add(ReportWords::tr("Path length"),
      ReportWords::tr("%1 %3, %2 %3 of it rapid")
          .arg(fixed(facts.path_length, Dimension::length), fixed(facts.rapid_length, Dimension::length),
               unit_of(Dimension::length)));
  if (facts.dwells > 0) {
    add(ReportWords::tr("Dwells"), clock_text(facts.dwell_time));
  }
  add(ReportWords::tr("Programmed feeds"), programmed_feeds_text(facts));
  if (facts.chord_error) {
    add(ReportWords::tr("Chord error"),
        ReportWords::tr("about %1 %2, estimated from %3 short lines")
            .arg(significant_number(in_shown_unit(facts.chord_error->value, Dimension::length), 2),
                 unit_of(Dimension::length))
            .arg(facts.chord_error->chords));
  }
  add(ReportWords::tr("Tools"), tools_text(program));
  if (const Message events = describe(facts.not_counted); !events.empty()) {
    add(ReportWords::tr("Not in the cycle time"), html_text(in_language(events)));
  }
  if (program.call_count > 0) {
    add(ReportWords::tr("Subprogram calls"), QString::number(program.call_count));
  }
  add(ReportWords::tr("Path control"), path_control_text(facts));
  const std::string_view text = program.source->text();
  add(QStringLiteral("SHA-256"),
      html_text(QString::fromLatin1(
          QCryptographicHash::hash(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())),
                                   QCryptographicHash::Sha256)
              .toHex())));
  return table.html();
}

QString programmed_feeds_text(const ProgramFacts& facts) {
  const QString slowest = significant_number(in_shown_unit(facts.min_feed, Dimension::feed), 6);
  const QString fastest = significant_number(in_shown_unit(facts.largest_feed, Dimension::feed), 6);
  return !(facts.largest_feed > 0) ? ReportWords::tr("none")
         : slowest == fastest
             ? fastest + ' ' + unit_of(Dimension::feed)
             : ReportWords::tr("%1 to %2 %3").arg(slowest, fastest, unit_of(Dimension::feed));
}

QString messages_block(const ReportInput& input) {
  constexpr std::size_t most = 50;
  const std::vector<RepeatedDiagnostic> messages = without_repeats(input.program().program->diagnostics);
  HtmlTable table("lrl", {12, 10, 78});
  table.add_head({ReportWords::tr("Severity"), ReportWords::tr("Line"), ReportWords::tr("Message")});
  for (const RepeatedDiagnostic& repeated : messages) {
    if (&repeated - messages.data() == most) {
      table.add({{}, {}, ReportWords::tr("and %1 more").arg(messages.size() - most)});
      break;
    }
    const Diagnostic& message = *repeated.first;
    const Message repeats = repeats_text(repeated);
    const QString also =
        repeats.empty() ? QString() : QStringLiteral("; %1").arg(html_text(in_language(repeats)));
    const QString hint =
        message.hint.empty() ? QString() : QStringLiteral(" (%1)").arg(html_text(in_language(message.hint)));
    const QString line = message.line == 0 ? QString() : QString::number(message.line);
    table.add({severity_text(message.severity), line, html_text(in_language(message.message)) + hint + also});
  }
  return table.empty() ? QString() : table.html();
}

QString run_label(const ReportInput& input, std::size_t run) {
  const QString letter =
      input.runs.size() > 1 ? QStringLiteral("<b>%1</b>&nbsp;").arg(run_letter(run)) : QString();
  return letter +
         QStringLiteral("<span style=\"color:%1\">■</span>&nbsp;%2")
             .arg(input.runs[run].colour.name(), html_text(short_names(input)[static_cast<qsizetype>(run)]));
}

}  // namespace feedscope::ui
