#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"
#include "core/program/text/source_text.h"

namespace feedscope {

/// Order in which the lines of the texts run: jumps, calls and repeats.
class LineRunner {
 public:
  /// `options` and `log` outlive it.
  LineRunner(std::shared_ptr<const SourceText> program, const ReadOptions& options, DiagnosticLog& log);

  /// The current text, and that of the program itself, for calls.
  const SourceText& text() const { return *text_; }
  const std::shared_ptr<const SourceText>& text_in_force() const { return text_; }
  const std::shared_ptr<const SourceText>& main_text() const { return program_; }
  bool in_main_text() const { return text_ == program_; }
  /// 1-based current line, in text().
  std::uint32_t line() const { return line_; }
  /// Current line, or the line of the program itself that called it.
  std::uint32_t shown_line() const;
  std::size_t call_depth() const { return calls_.size(); }
  DiagnosticLog::Place place(std::uint32_t column) const;

  /// Moves to the next line; false if the current text has no further one.
  bool advance();
  /// Continues with `line` of the current text.
  void jump_to(std::uint32_t line) { next_line_ = line; }
  /// Continues with `line` of `text`. return_from_call() then continues after the current line, or repeats
  /// the call until it has run `times` (>= 1). Returns false, with a report, beyond the depth of ReadOptions.
  bool call(std::shared_ptr<const SourceText> text, std::uint32_t line, std::uint32_t times = 1);
  bool call(std::uint32_t line, std::uint32_t times = 1) { return call(text_, line, times); }

  enum class Returned : std::uint8_t {
    no_call,  ///< nothing was called
    again,    ///< the call runs once more
    left,     ///< the caller goes on
  };
  Returned return_from_call();
  void end_program() { end_line_ = shown_line(); }
  bool ended() const { return end_line_ != 0; }
  /// Shown line at which the program ended; 0: not yet.
  std::uint32_t end_line() const { return end_line_; }
  /// The farthest shown line that ran.
  std::uint32_t last_run() const { return last_run_; }

  /// Number of lines that ran, and of calls.
  std::uint64_t lines_run() const { return lines_run_; }
  std::uint64_t call_count() const { return call_count_; }
  /// A block is a line with words.
  void count_block() { ++block_count_; }
  std::uint64_t block_count() const { return block_count_; }

 private:
  struct Call {
    std::shared_ptr<const SourceText> text;  ///< the caller's
    std::uint32_t line = 0;                  ///< of the call
    std::uint32_t start = 0;                 ///< first line of the call
    std::uint32_t times = 0;                 ///< left to run, including this one
  };

  const ReadOptions& options_;
  DiagnosticLog& log_;
  std::shared_ptr<const SourceText> program_;
  std::shared_ptr<const SourceText> text_;
  std::vector<Call> calls_;
  std::uint32_t line_ = 0;
  std::uint32_t next_line_ = 1;
  std::uint32_t end_line_ = 0;
  std::uint32_t last_run_ = 0;
  std::uint64_t lines_run_ = 0;
  std::uint64_t call_count_ = 0;
  std::uint64_t block_count_ = 0;
};

}  // namespace feedscope
