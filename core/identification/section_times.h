#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/text/source_text.h"

namespace feedscope {

/// Time of a section of a program, measured by a control or a stopwatch.
struct SectionTime {
  std::string section;    ///< "12", or "40-55" for lines
  double seconds = 0;     ///< [s]
  double resolution = 0;  ///< of the clock: common step of all times in the table [s]
  std::uint32_t row = 0;  ///< line of the table
};

/// Lines of a program, inclusive.
struct SectionLines {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Whether a text is a table of section times: its first row has the title "section" or "lines", and a time.
bool is_section_times(std::string_view head);

/// Reads such a table: columns separated by tab, semicolon or comma, titles "section" (or "lines") and
/// "seconds" (or "s", "time", "ms", "milliseconds"), others are ignored; empty rows and those that begin with
/// # are skipped. A section is the number of one marked by comments in the program, or lines such as "40-55".
/// Throws InputError with `name`, line and problem, or for fewer than four sections.
std::vector<SectionTime> parse_section_times(std::string_view text, const std::string& name);

/// Sections of a program: between the comments "SECTION 12 BEGINS" and "SECTION 12 ENDS".
class ProgramSections {
 public:
  explicit ProgramSections(const SourceText& program);

  /// Lines of a section, marked or named. Throws InputError with `table`, row and section if the program does
  /// not have it.
  SectionLines lines_of(const SectionTime& time, const std::string& table) const;

 private:
  std::map<std::uint32_t, SectionLines> marked_;  ///< by number; line 0 if a mark is missing
  std::string name_;                              ///< of the program
  std::uint32_t line_count_ = 0;
};

/// Mark of a section in a program: "SECTION 12 BEGINS".
std::string section_mark(std::size_t section, bool begins);

}  // namespace feedscope
