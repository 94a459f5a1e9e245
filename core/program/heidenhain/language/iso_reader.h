#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/program/heidenhain/language/iso_codes.h"
#include "core/program/heidenhain/language/iso_words.h"
#include "core/program/heidenhain/language/statement_reader.h"

namespace feedscope::heidenhain {

/// Reads Heidenhain DIN/ISO programs; README.md in this folder lists the words.
class HeidenhainIsoReader : public StatementReader {
 public:
  HeidenhainIsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                      Progress* progress);

 private:
  void run_statement(std::string_view statement) override;
  std::uint32_t first_word(std::string_view line) override;
  std::string label_on(std::string_view line);

  /// Reads the rest after "%": the frame of the program, or a call of another one.
  void run_percent(std::string_view rest, std::uint32_t column);
  void run_d_function(Scanner& scanner, std::uint32_t column);
  void run_block(IsoBlock& block);
  void run_tool(const IsoBlock& block);

  IsoWords words_;
  IsoMotions motions_;
  IsoCodes codes_;
  bool begun_ = false;
};

}  // namespace feedscope::heidenhain
