#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/program/heidenhain/language/cycle_statements.h"
#include "core/program/heidenhain/language/fn_statements.h"
#include "core/program/heidenhain/language/path_statements.h"
#include "core/program/heidenhain/language/program_statements.h"
#include "core/program/heidenhain/language/statement_reader.h"

namespace feedscope::heidenhain {

/// Reads Heidenhain conversational programs; README.md in this folder lists the words. The name of a
/// statement selects the part that runs it.
class HeidenhainReader : public StatementReader {
 public:
  HeidenhainReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress);

 private:
  void run_statement(std::string_view statement) override;
  void run_words(std::string_view name, std::size_t start, Scanner& scanner, std::uint32_t column);
  /// The end of the program counts as none.
  std::uint32_t first_word(std::string_view line) override;
  std::string label_on(std::string_view line);

  Words words_;
  UnsupportedStatements unsupported_;
  PathStatements path_statements_;
  ProgramStatements program_statements_;
  FnStatements fn_statements_;
  CycleStatements cycle_statements_;
};

}  // namespace feedscope::heidenhain
