#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/program/machining.h"

namespace feedscope {

/// Runs a program line by line, as a control does. The dialect derives from this class and interprets the
/// lines with parts that work on the Machining.
class Reader {
 public:
  Reader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress);
  virtual ~Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Runs the whole program, once.
  ReadProgram read();

 protected:
  using Text = DiagnosticLog::Text;

  /// Runs the current line, without its line end. ReadFault is caught and reported.
  virtual void run_line(std::string_view line) = 0;
  /// Called where the current text has no further line, in a call.
  virtual void run_out() = 0;
  /// Called after the last line: the dialect writes everything that is still pending.
  virtual void finish() {}
  /// 1-based column of the first word of `line`, 0 for none; for the message that text after the end is not
  /// run.
  virtual std::uint32_t first_word(std::string_view line) = 0;

  Machining& machining() { return machining_; }
  const Machining& machining() const { return machining_; }
  SubprogramFiles& subprogram_files() { return files_; }

  const ReadOptions& options() const { return options_; }
  PathWriter& path() { return path_; }
  const PathWriter& path() const { return path_; }
  LineRunner& lines() { return lines_; }
  const LineRunner& lines() const { return lines_; }
  template <typename MakeText>
  void report(Severity severity, MessageCode code, int detail, std::uint32_t column, MakeText&& text) {
    machining_.report(severity, code, detail, column, text);
  }

 private:
  bool within_run_limit();
  void report_nothing_read();
  void report_text_after_end();

  ReadOptions options_;
  Progress* progress_;
  ReadProgram program_;
  DiagnosticLog log_;
  PathWriter path_;
  LineRunner lines_;
  SubprogramFiles files_;
  ToolRack tools_;
  OtherAxes other_axes_;
  UnitTracker unit_;
  Machining machining_;
};

}  // namespace feedscope
