#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/program/program.h"
#include "core/program/text/diagnostic_log.h"
#include "core/program/text/source_text.h"

namespace feedscope {

/// Which line of which text runs next: jumps, calls and repeats.
class LineRunner {
 public:
  /// `options` and `log` outlive it.
  LineRunner(std::shared_ptr<const SourceText> program, const ReadOptions& options, DiagnosticLog& log);

  /// The text in force, and that of the program itself, to call.
  const SourceText& text() const { return *text_; }
  const std::shared_ptr<const SourceText>& text_in_force() const { return text_; }
  const std::shared_ptr<const SourceText>& main_text() const { return program_; }
  bool in_main_text() const { return text_ == program_; }
  /// 1-based, of the line in force, in text().
  std::uint32_t line() const { return line_; }
  /// Line of the program itself that the line in force was called from, or is.
  std::uint32_t shown_line() const;
  std::size_t call_depth() const { return calls_.size(); }
  DiagnosticLog::Place place(std::uint32_t column) const;

  /// False if the text in force has no further line; else the next one is in force.
  bool advance();
  /// The next line that runs is `line` of the text in force.
  void jump_to(std::uint32_t line) { next_line_ = line; }
  /// The next line that runs is `line` of `text`; after return_from_call() it goes on behind the line in
  /// force, or runs the call again until it has run `times` (>= 1). False, and reported, beyond the depth
  /// that ReadOptions allow.
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
  /// Shown line at which the program ended; 0: it has not.
  std::uint32_t end_line() const { return end_line_; }
  /// The farthest shown line that ran.
  std::uint32_t last_run() const { return last_run_; }

  /// Lines that ran, and calls.
  std::uint64_t lines_run() const { return lines_run_; }
  std::uint64_t call_count() const { return call_count_; }
  /// A block is a line that holds words.
  void count_block() { ++block_count_; }
  std::uint64_t block_count() const { return block_count_; }

 private:
  struct Call {
    std::shared_ptr<const SourceText> text;  ///< that goes on
    std::uint32_t line = 0;                  ///< of the call
    std::uint32_t start = 0;                 ///< first line of what is called
    std::uint32_t times = 0;                 ///< left to run, this one included
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
