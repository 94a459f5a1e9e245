#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/path/path_writer.h"
#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"
#include "core/program/text/subprogram_files.h"
#include "core/program/tools/cutters.h"

namespace feedscope {

/// Runs a program line by line, as a control does: with jumps, calls and repeats. What a line means is the
/// dialect's, which derives from this class; where the path goes is the PathWriter's.
class Reader {
 public:
  Reader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress);
  virtual ~Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Runs the whole program, once.
  Program read();

 protected:
  using Text = DiagnosticLog::Text;

  /// One line in force, without its end. ReadFault is caught and reported.
  virtual void run_line(std::string_view line) = 0;
  /// The text in force has no further line. By default a called one returns, the program itself ends.
  virtual void run_out();
  /// The last line has run: what the dialect holds back goes to path() now.
  virtual void before_finish() {}
  /// A call was left, by return_from_call() or at the end of its file.
  virtual void left_call() {}
  /// Behind the last line: what is held back is written now.
  virtual void finish() {}
  /// 1-based column of the first word of `line`, 0 for none; to say that text behind the end is not run.
  virtual std::uint32_t first_word(std::string_view line) = 0;

  const SourceText& text() const { return *text_; }
  /// The text in force, and that of the program itself, to call.
  const std::shared_ptr<const SourceText>& text_in_force() const { return text_; }
  const std::shared_ptr<const SourceText>& main_text() const { return program_.source; }
  /// 1-based, of the line in force, in text().
  std::uint32_t line() const { return line_; }
  bool in_main_text() const { return text_ == program_.source; }
  std::size_t call_depth() const { return calls_.size(); }

  /// The next line that runs is `line` of the text in force.
  void jump_to(std::uint32_t line) { next_line_ = line; }
  /// The next line that runs is `line` of `text`; after return_from_call() it goes on behind the line in
  /// force, or runs the call again until it has run `times` (>= 1). False, and reported, beyond the depth
  /// that ReadOptions allow.
  bool call(std::shared_ptr<const SourceText> text, std::uint32_t line, std::uint32_t times = 1);
  bool call(std::uint32_t line, std::uint32_t times = 1) { return call(text_, line, times); }
  /// False if nothing was called.
  bool return_from_call();
  void end_program() { end_line_ = shown_line(); }
  bool ended() const { return end_line_ != 0; }

  /// The unit that holds until the program says one.
  LengthUnit first_unit() const { return options_.unit.value_or(LengthUnit::mm); }
  /// The program says its unit.
  void say_unit(LengthUnit unit) { said_unit_ = unit; }

  /// Line of the program itself that the line in force was called from, or is.
  std::uint32_t shown_line() const;
  /// The program asks for a tool, by number or name.
  void select_tool(std::string_view name);
  /// Radius of a cutter [mm], which the program says to be `programmed`; none if nobody knows it.
  std::optional<double> cutter_radius(std::string_view tool, std::optional<double> programmed);
  /// The same where the path depends on it: Program::cutters names it.
  std::optional<double> use_cutter(std::string_view tool, std::optional<double> programmed);
  /// What to do about a radius that nobody knows, behind "the path shown is the programmed contour; ".
  static std::string radius_hint(std::string_view tool);
  /// How an axis other than X, Y and Z moves.
  enum class AxisMotion : std::uint8_t {
    positions,  ///< on its own, or with a rapid: the path beside it is right
    cuts,       ///< in a feed move
    at_tip,     ///< in a feed move whose X, Y and Z are those of the tool's tip
  };
  /// It goes to `target`, which is said once of each axis and kind of motion; a name with a blank in it,
  /// "tool orientation", stands for several axes.
  void note_other_axis(std::string_view axis, double target, AxisMotion motion, std::uint32_t column);
  /// The tool named last comes into the spindle; nothing if it is there.
  void change_tool(std::string_view name);
  /// M3, M4: nothing where the spindle turns. M5 and its like.
  void start_spindle();
  bool spindle_turns() const { return spindle_turns_; }
  void stop_spindle() { spindle_turns_ = false; }
  /// M0, M1.
  void stop_program() { path_.pause(Pause::stop); }
  /// `what` sends axes to a position that only the machine knows: a warning.
  void report_machine_move(std::string_view what, std::string_view code, std::uint32_t column);
  /// Counts a block: a line that holds words.
  void count_block() { ++program_.block_count; }

  template <typename MakeText>
  void report(Severity severity, std::string_view code, int detail, std::uint32_t column, MakeText&& text) {
    log_.add(severity, code, detail, place(column), text);
  }
  DiagnosticLog::Place place(std::uint32_t column) const;

  const ReadOptions& options() const { return options_; }
  SubprogramFiles& subprogram_files() { return files_; }
  PathWriter& path() { return path_; }
  const PathWriter& path() const { return path_; }
  DiagnosticLog& log() { return log_; }

 private:
  struct Call {
    std::shared_ptr<const SourceText> text;  ///< that goes on
    std::uint32_t line = 0;                  ///< of the call
    std::uint32_t start = 0;                 ///< first line of what is called
    std::uint32_t times = 0;                 ///< left to run, this one included
  };

  struct OtherAxis {
    std::string name;
    std::array<bool, 3> said{};  ///< by AxisMotion
  };

  bool within_run_limit();
  void watch_unit();
  void settle_unit();
  void report_assumed_unit();
  void report_nothing_read();
  void report_text_after_end();

  ReadOptions options_;
  Progress* progress_;
  Program program_;
  DiagnosticLog log_;
  PathWriter path_;
  SubprogramFiles files_;
  Cutters cutters_;
  std::shared_ptr<const SourceText> text_;
  std::vector<Call> calls_;
  std::vector<OtherAxis> other_axes_;
  std::optional<LengthUnit> said_unit_;
  std::size_t first_motion_ = 0;  ///< the first of Program::motions with a length, once unit_settled_
  bool unit_settled_ = false;
  std::uint32_t line_ = 0;
  std::uint32_t next_line_ = 1;
  std::uint32_t end_line_ = 0;  ///< shown; 0: not met
  std::uint32_t last_run_ = 0;  ///< the farthest shown line that ran
  std::uint64_t lines_run_ = 0;
  std::optional<std::string> tool_in_spindle_;
  bool spindle_turns_ = false;
};

}  // namespace feedscope
