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

/// Shared state for every part of a reader: the run of the program's lines, the resulting path, tools and
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

  /// Reports at a column of the current line; 0: the line as a whole.
  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) const {
    log.add(severity, code, detail, lines.place(column), text);
  }
  /// Reports a fault of the current line.
  void report(const ReadFault& fault) const;
  /// Warns that `what` sends axes to a position that only the machine knows.
  void report_machine_move(std::string_view what, MessageCode code, std::uint32_t column) const;
  /// Unit vector from the tip to the spindle in shown coordinates for a vector of the program. Empty, with an
  /// error, for a vector of length zero: `words` names its words, `example` shows one.
  std::optional<Vec3> tool_direction(const Vec3& vector, const Message& words, std::string_view example,
                                     std::uint32_t column) const;
};

}  // namespace feedscope
