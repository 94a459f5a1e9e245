#pragma once

#include <memory>
#include <string_view>

#include "core/program/heidenhain/language/parts.h"
#include "core/program/reader.h"

namespace feedscope::heidenhain {

/// Runs the statements of a program's lines; the language interprets them.
class StatementReader : public Reader {
 protected:
  StatementReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress,
                  Dialect dialect, Labels::OfLine label_of_line)
      : Reader(std::move(source), options, progress),
        parts_(machining(), dialect, subprogram_files(), std::move(label_of_line)) {}

  /// Runs one statement, comments removed, possibly from several lines. ReadFault is caught.
  virtual void run_statement(std::string_view statement) = 0;

  Parts& parts() { return parts_; }

 private:
  void run_line(std::string_view line) override;
  void run_out() override;
  void finish() override;
  void run_joined(std::string_view statement);

  Parts parts_;
};

}  // namespace feedscope::heidenhain
