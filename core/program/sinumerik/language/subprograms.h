#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/program/language/line_runner.h"
#include "core/program/sinumerik/language/program_indexes.h"
#include "core/program/text/subprogram_files.h"

namespace feedscope::sinumerik {

/// Start of a subprogram.
struct Subprogram {
  std::shared_ptr<const SourceText> text;  ///< nullptr: not found
  std::uint32_t line = 1;                  ///< 1-based
};

/// The name without folder and extension, in upper case: "/_N_SPF_DIR/_N_NAME_SPF", "name.SPF" and "NAME" are
/// the same subprogram.
std::string plain_name(std::string_view written);

/// Finds subprograms: in the current text, in the program itself, then in files of the program's folder.
class Subprograms {
 public:
  /// All outlive it.
  Subprograms(const LineRunner& lines, ProgramIndexes& indexes, SubprogramFiles& files)
      : lines_(lines), indexes_(indexes), files_(files) {}

  /// By its name as written.
  Subprogram find(std::string_view written);

 private:
  const LineRunner& lines_;
  ProgramIndexes& indexes_;
  SubprogramFiles& files_;
};

}  // namespace feedscope::sinumerik
