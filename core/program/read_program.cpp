
#include <algorithm>

#include "core/program/heidenhain/language/iso_reader.h"
#include "core/program/heidenhain/reader.h"
#include "core/program/iso/reader.h"
#include "core/program/program.h"
#include "core/program/sinumerik/reader.h"

namespace feedscope {

namespace {

constexpr std::string_view not_fitting = "arc-radius";

void say_centers_are_positions(Program& program, const std::vector<Diagnostic>& as_offsets) {
  const auto first = std::find_if(as_offsets.begin(), as_offsets.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.code == not_fitting && diagnostic.file.empty();
  });
  const std::uint32_t line = first == as_offsets.end() ? 0 : first->line;
  const std::uint32_t column = first == as_offsets.end() ? 0 : first->column;
  const auto behind = std::find_if(program.diagnostics.begin(), program.diagnostics.end(),
                                   [line](const Diagnostic& diagnostic) { return diagnostic.line > line; });
  program.diagnostics.insert(behind, {Severity::warning, line, column, "arc-centers",
                                      NC_("core",
                                          "I J K are used as positions: as offsets from the start most arcs "
                                          "do not fit, as positions all of them do"),
                                      NC_("core", "program G90.1 if that is right, G91.1 if not")});
}

ReadProgram read_iso(const std::shared_ptr<const SourceText>& source, const ReadOptions& options,
                     Progress* progress) {
  iso::IsoReader reader(source, options, progress);
  ReadProgram program = reader.read();
  if (!reader.doubts_centers()) {
    return program;
  }
  iso::IsoReader again(source, options, progress, true);
  ReadProgram other = again.read();
  if (!again.centers_fit()) {
    return program;
  }
  say_centers_are_positions(other, program.diagnostics);
  return other;
}

ReadProgram read_as(Dialect dialect, std::shared_ptr<const SourceText> source, const ReadOptions& options,
                    Progress* progress) {
  switch (dialect) {
    case Dialect::sinumerik:
      return sinumerik::SinumerikReader(std::move(source), options, progress).read();
    case Dialect::heidenhain:
      return heidenhain::HeidenhainReader(std::move(source), options, progress).read();
    case Dialect::heidenhain_iso:
      return heidenhain::HeidenhainIsoReader(std::move(source), options, progress).read();
    default:
      return read_iso(source, options, progress);
  }
}

/// First, because it explains more of the program than all diagnostics that follow from it.
void say_foreign(Program& program, const ForeignLanguage& language) {
  program.diagnostics.insert(
      program.diagnostics.begin(),
      {Severity::error, language.line, 0, "unsupported-control",
       message(NC_("core", "this is a program for {}, which is not supported"), language.title),
       message(NC_("core",
                   "it is interpreted as ISO and the path shown may be wrong: {}; give --dialect to "
                   "interpret it as that dialect"),
               language.meaning)});
}

}  // namespace

ReadProgram read_program(std::shared_ptr<const SourceText> source, Progress* progress,
                         const ReadOptions& options) {
  ReadOptions resolved = options;
  resolved.dialect = options.dialect.value_or(recognise(*source));
  const std::optional<ForeignLanguage> foreign = options.dialect ? std::nullopt : recognise_foreign(*source);
  ReadProgram program = read_as(*resolved.dialect, std::move(source), resolved, progress);
  if (foreign) {
    say_foreign(program, *foreign);
  }
  program.dialect = *resolved.dialect;
  return program;
}

}  // namespace feedscope
