#include "ui/report/report_tables.h"

#include <QCryptographicHash>
#include <cmath>

#include "core/analysis/not_counted.h"
#include "core/analysis/program_facts.h"
#include "core/base/units.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/report/html_table.h"
#include "ui/report/report_numbers.h"

namespace feedscope::ui {

namespace {

constexpr qsizetype max_ranges = 40;  // of path control that are listed

QString range_text(const Bounds& bounds, int axis) {
  const double from = bounds.min[axis];
  const double to = bounds.max[axis];
  return std::isfinite(from) && std::isfinite(to)
             ? QStringLiteral("%1 to %2 %3")
                   .arg(fixed(from, Dimension::length), fixed(to, Dimension::length),
                        unit_of(Dimension::length))
             : QStringLiteral("not programmed");
}

QString extent_text(const ProgramFacts& facts, int axis) {
  return QStringLiteral("%1; cutting %2; rapid %3")
      .arg(range_text(facts.bounds, axis), range_text(facts.cutting_bounds, axis),
           range_text(facts.rapid_bounds, axis));
}

QString tools_text(const Program& program) {
  QStringList names;
  for (const ToolChange& tool : program.tools) {
    names.append(QStringLiteral("%1 (line %2)").arg(html_text(tool.name)).arg(tool.line));
  }
  return names.isEmpty() ? QStringLiteral("none programmed") : names.join(QStringLiteral(", "));
}

QString lines_text(std::uint32_t first, std::uint32_t last) {
  return first == last ? QStringLiteral("line %1").arg(first)
                       : QStringLiteral("lines %1 to %2").arg(first).arg(last);
}

QString path_control_text(const ProgramFacts& facts) {
  QStringList lines;
  for (const PathControlRange& range : facts.path_control) {
    if (lines.size() == max_ranges) {
      lines.append(QStringLiteral("and %1 more").arg(facts.path_control.size() - lines.size()));
      break;
    }
    lines.append(QStringLiteral("%1: %2").arg(lines_text(range.first_line, range.last_line),
                                              html_text(describe(range.control))));
  }
  return lines.isEmpty() ? QStringLiteral("as the machine") : lines.join(QStringLiteral("<br/>"));
}

QString severity_text(Severity severity) {
  return QString::fromUtf8(to_string(severity).data(), static_cast<qsizetype>(to_string(severity).size()));
}

}  // namespace

QString program_facts_block(const ReportInput& input) {
  const Program& program = *input.program().program;
  const ProgramFacts facts = facts_of(program, *input.program().toolpath);
  HtmlTable table("ll", {24, 76});
  const auto add = [&](const char* name, const QString& value) {
    table.add({QString::fromUtf8(name), value});
  };
  add("File", html_text(program.source->name()));
  add("Dialect", html_text(std::string(info_of(program.dialect).title)));
  add("Unit", html_text(describe(program.unit)));
  add("Size", QStringLiteral("%1 lines, %2 blocks run").arg(facts.lines).arg(program.block_count));
  add("Segments", QStringLiteral("%1: %2 lines, %3 arcs, %4 dwells")
                      .arg(facts.segments)
                      .arg(facts.segments - facts.arcs - facts.dwells)
                      .arg(facts.arcs)
                      .arg(facts.dwells));
  for (int axis = 0; axis < 3; ++axis) {
    table.add({QStringLiteral("Extent of %1").arg(QChar(coordinate_names[static_cast<std::size_t>(axis)])),
               extent_text(facts, axis)});
  }
  add("Path length", QStringLiteral("%1 %3, %2 %3 of it rapid")
                         .arg(fixed(facts.path_length, Dimension::length),
                              fixed(facts.rapid_length, Dimension::length), unit_of(Dimension::length)));
  if (facts.dwells > 0) {
    add("Dwells", clock_text(facts.dwell_time));
  }
  add("Programmed feeds",
      facts.largest_feed > 0
          ? QStringLiteral("%1 to %2 %3")
                .arg(significant(facts.min_feed, Dimension::feed, 6),
                     significant(facts.largest_feed, Dimension::feed, 6), unit_of(Dimension::feed))
          : QStringLiteral("none"));
  if (facts.chord_error) {
    add("Chord error",
        QStringLiteral("about %1 %2, estimated from %3 short lines")
            .arg(significant(facts.chord_error->value, Dimension::length, 2), unit_of(Dimension::length))
            .arg(facts.chord_error->chords));
  }
  add("Tools", tools_text(program));
  if (const std::string events = describe(facts.not_counted); !events.empty()) {
    add("Not in the cycle time", html_text(events));
  }
  if (program.call_count > 0) {
    add("Subprogram calls", QString::number(program.call_count));
  }
  add("Path control", path_control_text(facts));
  const std::string_view text = program.source->text();
  add("SHA-256",
      html_text(QString::fromLatin1(
          QCryptographicHash::hash(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())),
                                   QCryptographicHash::Sha256)
              .toHex())));
  return table.html();
}

QString messages_block(const ReportInput& input) {
  constexpr std::size_t most = 50;
  const std::vector<RepeatedDiagnostic> messages = without_repeats(input.program().program->diagnostics);
  HtmlTable table("lrl", {12, 10, 78});
  table.add_head({QStringLiteral("Severity"), QStringLiteral("Line"), QStringLiteral("Message")});
  for (const RepeatedDiagnostic& repeated : messages) {
    if (&repeated - messages.data() == most) {
      table.add({{}, {}, QStringLiteral("and %1 more").arg(messages.size() - most)});
      break;
    }
    const Diagnostic& message = *repeated.first;
    const std::string repeats = repeats_text(repeated);
    const QString also = repeats.empty() ? QString() : QStringLiteral("; %1").arg(html_text(repeats));
    const QString hint =
        message.hint.empty() ? QString() : QStringLiteral(" (%1)").arg(html_text(message.hint));
    const QString line = message.line == 0 ? QString() : QString::number(message.line);
    table.add({severity_text(message.severity), line, html_text(message.message) + hint + also});
  }
  return table.empty() ? QString() : table.html();
}

QString run_label(const ReportRun& run) {
  return QStringLiteral("<span style=\"color:%1\">■</span>&nbsp;%2")
      .arg(run.colour.name(), html_text(run.name));
}

}  // namespace feedscope::ui
