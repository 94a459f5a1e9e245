#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "core/program/iso/language/flow_indexes.h"
#include "core/program/language/line_runner.h"
#include "core/program/text/subprogram_files.h"

namespace feedscope::iso {

/// Start of a subprogram.
struct Subprogram {
  std::shared_ptr<const SourceText> text;  ///< nullptr: not found
  std::uint32_t line = 0;                  ///< 1-based
};

/// True for a possible program number.
bool is_program_number(double value);

/// Finds subprograms: in the current text, in the program itself, then in files of the program's folder.
class Subprograms {
 public:
  /// All outlive it.
  Subprograms(const LineRunner& lines, FlowIndexes& indexes, SubprogramFiles& files)
      : lines_(lines), indexes_(indexes), files_(files) {}

  /// O100, or "o100 sub".
  Subprogram program(double number);
  /// "o<name> sub", by its normal label: "<name>" or "100".
  Subprogram sub(const std::string& label);
  /// By file name.
  Subprogram file(const std::string& name);

 private:
  const LineRunner& lines_;
  FlowIndexes& indexes_;
  SubprogramFiles& files_;
  std::map<std::uint32_t, std::shared_ptr<const SourceText>> program_files_;  ///< by number, nullptr: none
};

}  // namespace feedscope::iso
