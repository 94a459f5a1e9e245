#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/language/values.h"
#include "core/program/text/subprogram_files.h"

namespace feedscope::sinumerik {

/// What parts of the reader work on, to test them alone: the lines of a program, none of which is run.
struct PartBench {
  explicit PartBench(std::string text = "G1\n")
      : lines(std::make_shared<const SourceText>("test.mpf", std::move(text)), options, log) {}

  /// The line runner stands in `line`, which it reaches line by line.
  void go_to(std::uint32_t line) {
    lines.jump_to(line);
    lines.advance();
  }
  /// The line that runs next.
  std::uint32_t next_line() { return lines.advance() ? lines.line() : 0; }

  void set(char letter, double value, Reading reading = Reading::modal) {
    context.words.set(letter, {.value = value, .column = 1, .reading = reading});
  }
  void set(Address address, double value, Reading reading = Reading::modal) {
    context.words.set(address, {.value = value, .column = 1, .reading = reading});
  }
  /// A block of its own begins.
  void clear() {
    context.words.clear();
    context.functions = {};
  }

  ReadOptions options;
  ReadProgram program;
  DiagnosticLog log;
  PathWriter path{program, log};
  LineRunner lines;
  SubprogramFiles files{{}};
  ToolRack tools{options, files, program, path, lines, log};
  OtherAxes other_axes{program, lines, log, options};
  UnitTracker unit{options, program};
  Machining machining{options, log, path, lines, tools, other_axes, unit};
  Context context{.machining = machining};
  Values values{path, [](MessageCode, int, std::uint32_t, const DiagnosticLog::Text&) {}};
};

}  // namespace feedscope::sinumerik
