#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/program/text/scanner.h"
#include "core/program/text/source_text.h"

namespace feedscope::sinumerik {

/// A line without its comment, which ";" starts outside of quoted texts.
std::string_view without_comment(std::string_view line);

/// Scanner at the first word after block delete, block number and label of a line without comment.
Scanner first_statement(std::string_view line);

/// Jump targets of a text: labels, block numbers, the ends of IF, FOR, WHILE, LOOP and REPEAT, and the
/// programs that share the file, each after a head such as "%_N_PART_MPF".
class ProgramIndex {
 public:
  explicit ProgramIndex(const SourceText& text);

  /// One of the programs of the file; a file without heads is one.
  struct Section {
    std::string name;  ///< upper case, without "_N_" and extension
    bool main = false;
    std::uint32_t first = 1;  ///< line after the head
    std::uint32_t last = 0;
  };
  /// Lines that belong together; 0: there is none.
  struct Structure {
    std::uint32_t begin = 0;
    std::uint32_t middle = 0;  ///< ELSE
    std::uint32_t end = 0;
  };

  /// nullptr if the file has none of that name.
  const Section* section(std::string_view name) const;
  /// The program that contains `line`.
  const Section& section_of(std::uint32_t line) const;
  /// The first main program of a file with heads; nullptr if there is none.
  const Section* main_section() const;

  /// The next line with the label or block number ("N20") after `from`, or before it, in the same program;
  /// 0 if there is none.
  std::uint32_t forward(std::string_view label, std::uint32_t from) const;
  std::uint32_t backward(std::string_view label, std::uint32_t from) const;
  /// Structure of the control word in `line`.
  Structure structure(std::uint32_t line) const;

 private:
  struct Open {
    std::string_view end;
    std::uint32_t line = 0;
    std::uint32_t middle = 0;
  };

  void add_head(std::string_view line, std::uint32_t number);
  void add_line(std::string_view line, std::uint32_t number, std::vector<Open>& open);
  void close(std::string_view word, std::uint32_t number, std::vector<Open>& open);
  const std::vector<std::uint32_t>* lines_of(std::string_view label) const;

  std::vector<Section> sections_;
  std::unordered_map<std::string, std::vector<std::uint32_t>> labels_;
  std::unordered_map<std::uint32_t, Structure> structures_;
};

}  // namespace feedscope::sinumerik
