#pragma once

#include <optional>
#include <string_view>

#include "core/program/language/line_runner.h"
#include "core/program/language/unit_tracker.h"
#include "core/program/path/other_axes.h"
#include "core/program/path/path_writer.h"
#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"
#include "core/program/text/read_fault.h"
#include "core/program/tools/tool_rack.h"

namespace feedscope {

/// What every part of a reader works on: the run of the program's lines, the path that comes out, tools and
/// messages. The members outlive the parts.
struct Machining {
  using Text = DiagnosticLog::Text;

  const ReadOptions& options;
  DiagnosticLog& log;
  PathWriter& path;
  LineRunner& lines;
  ToolRack& tools;
  OtherAxes& other_axes;
  UnitTracker& unit;

  /// Reports at a column of the line in force; 0: the line as a whole.
  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    log.add(severity, code, detail, lines.place(column), text);
  }
  /// Reports a fault of the line in force.
  void report(const ReadFault& fault) const;
  /// `what` sends axes to a position that only the machine knows: a warning.
  void report_machine_move(std::string_view what, MessageCode code, std::uint32_t column) const;
  /// Direction from the tip to the spindle in the coordinates that are shown, of length 1, that a vector of
  /// the program gives. None, and an error, where it has no length: `words` names its words, `example` writes
  /// one.
  std::optional<Vec3> tool_direction(const Vec3& vector, const Message& words, std::string_view example,
                                     std::uint32_t column) const;
};

}  // namespace feedscope
