#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/text/source_text.h"

namespace feedscope {

/// Time of a section of a program, as a control or a stopwatch took it.
struct SectionTime {
  std::string section;    ///< "12", or "40-55" for lines
  double seconds = 0;     ///< [s]
  double resolution = 0;  ///< of the clock: the step that all times of the table have in common [s]
  std::uint32_t row = 0;  ///< line of the table
};

/// Lines of a program, both included.
struct SectionLines {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Whether a text is a table of section times: its first row has the titles "section" or "lines", and a time.
bool is_section_times(std::string_view head);

/// Reads such a table: columns by tab, semicolon or comma, titles "section" (or "lines") and "seconds" (or
/// "s", "time", "ms", "milliseconds"), others are of no use; rows that are empty or begin with # are skipped.
/// A section is the number of one that the program marks by comments, or the lines "40-55". Throws InputError
/// naming `name`, line and what is wrong, or if there are fewer than four.
std::vector<SectionTime> parse_section_times(std::string_view text, const std::string& name);

/// Where the sections of a program are: between the comments "SECTION 12 BEGINS" and "SECTION 12 ENDS".
class ProgramSections {
 public:
  explicit ProgramSections(const SourceText& program);

  /// The lines of a section, or those that its name says. Throws InputError naming `table`, row and section
  /// if the program does not have it.
  SectionLines lines_of(const SectionTime& time, const std::string& table) const;

 private:
  std::map<std::uint32_t, SectionLines> marked_;  ///< by number; a line of 0 where a mark is missing
  std::string name_;                              ///< of the program
  std::uint32_t line_count_ = 0;
};

/// What begins and ends a section in a program: "SECTION 12 BEGINS".
std::string section_mark(std::size_t section, bool begins);

}  // namespace feedscope
