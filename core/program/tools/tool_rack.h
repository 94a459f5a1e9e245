#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/program/language/line_runner.h"
#include "core/program/path/path_writer.h"
#include "core/program/program.h"
#include "core/program/text/subprogram_files.h"
#include "core/program/tools/cutters.h"

namespace feedscope {

/// Tools of a program, the one in the spindle, and whether the spindle turns.
class ToolRack {
 public:
  /// All outlive it. Throws InputError for an unreadable tool table of `options`.
  ToolRack(const ReadOptions& options, SubprogramFiles& files, Program& program, PathWriter& path,
           const LineRunner& lines, DiagnosticLog& log);

  /// Selects a tool, by number or name.
  void select(std::string_view name);
  /// Brings the tool into the spindle; does nothing if it is there.
  void change_to(std::string_view name);

  /// M3, M4: does nothing if the spindle turns. M5 and similar.
  void start_spindle();
  void stop_spindle();
  bool spindle_turns() const { return spindle_turns_; }

  /// Radius of a cutter [mm], for which the program gives `programmed`; none if it is not given anywhere.
  std::optional<double> radius_of(std::string_view tool, std::optional<double> programmed);
  /// The same where the path depends on it: adds the tool to Program::cutters.
  std::optional<double> use_radius_of(std::string_view tool, std::optional<double> programmed);
  /// Hint for a radius that is not given anywhere, after "the path shown is the programmed contour; ".
  static Message radius_hint(std::string_view tool);

 private:
  /// Index in Program::tools; -1 if it is not there.
  std::int32_t index_of(std::string_view name) const;

  Program& program_;
  PathWriter& path_;
  const LineRunner& lines_;
  DiagnosticLog& log_;
  Cutters cutters_;
  std::optional<std::string> in_spindle_;
  bool spindle_turns_ = false;
  bool spindle_commanded_ = false;  ///< the program has started or stopped it at least once
};

}  // namespace feedscope
