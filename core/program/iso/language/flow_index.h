#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/program/text/scanner.h"
#include "core/program/text/source_text.h"

namespace feedscope::iso {

/// Flow words of LinuxCNC's O words and Fanuc's macro statements.
enum class FlowWord : std::uint8_t {
  none,
  sub,
  endsub,
  call,
  if_,
  elseif,
  else_,
  endif,
  do_,
  while_,
  endwhile,
  repeat,
  endrepeat,
  break_,
  continue_,
  return_,
  macro_do,  ///< Fanuc's DO n, with or without WHILE
  macro_end,
};

/// Reads a word of Fanuc's macro statements, of which the first two letters are enough: "WH" for WHILE.
bool take_macro_word(Scanner& scan, std::string_view word);
/// FlowWord::none for a name that is not one of an O word.
FlowWord o_word_named(std::string_view name);
/// Reads the label of an O word after its O: "100" without leading zeros, "<name>" normal; empty if it is
/// neither digits nor a name.
std::string take_o_label(Scanner& scanner);

/// Places where the jumps, loops and subprograms of a text begin and end.
class FlowIndex {
 public:
  struct Statement {
    std::uint32_t line = 0;  ///< 1-based
    FlowWord word = FlowWord::none;
    std::uint32_t begin = 0;  ///< line of the word that opens its group; 0: none
    std::uint32_t next = 0;   ///< line of the next branch of an if, or of its end; 0: none
    std::uint32_t end = 0;    ///< line of the word that closes its group; 0: none
  };

  FlowIndex() = default;
  /// `skip_deleted`: lines that begin with "/" do not count.
  FlowIndex(const SourceText& text, bool skip_deleted);

  /// The flow statement in a line; nullptr if there is none.
  const Statement* at(std::uint32_t line) const;
  /// Lines of the "sub" within the sub that `statement` opens.
  std::vector<std::uint32_t> subs_within(const Statement& statement) const;
  /// Line of "o<label> sub"; 0: none.
  std::uint32_t sub(const std::string& label) const;
  /// Line of an O number that begins a program; 0: none.
  std::uint32_t program(std::uint32_t number) const;
  /// Line of block N`number`, searched from `line` on and then from the start of the program that contains
  /// `line`; 0: none.
  std::uint32_t block(std::uint32_t number, std::uint32_t line) const;

 private:
  /// A statement that is not closed yet, and its last branch so far.
  struct Opened {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void read_line(Scanner scan, std::uint32_t line);
  void read_o_word(Scanner& scan, std::uint32_t line);
  void add(FlowWord word, const std::string& label, std::uint32_t line);
  void open(const Statement& statement, const std::string& key);
  void branch(Statement statement, const std::string& key);
  void close(Statement statement, const std::string& key);
  void leave_loop(Statement statement, const std::string& key);

  std::vector<Statement> statements_;  ///< by line
  std::map<std::string, std::uint32_t> subs_;
  std::map<std::uint32_t, std::uint32_t> programs_;               ///< number to line
  std::vector<std::uint32_t> program_lines_;                      ///< ascending
  std::vector<std::pair<std::uint32_t, std::uint32_t>> numbers_;  ///< N number and line, ascending
  /// By kind and label, innermost last; while the text is read.
  std::map<std::string, std::vector<Opened>> open_;
};

}  // namespace feedscope::iso
