#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/program/heidenhain/context.h"
#include "core/program/text/subprogram_files.h"

namespace feedscope::heidenhain {

/// What parts of the readers work on, to test them alone: the lines of a program, none of which is run.
struct PartBench {
  explicit PartBench(std::string text = "L X+1\n")
      : lines(std::make_shared<const SourceText>("test.h", std::move(text)), options, log) {
    lines.advance();
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
  Context context{machining, Dialect::heidenhain};
};

}  // namespace feedscope::heidenhain
