#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/iso/context.h"
#include "core/program/iso/language/expression.h"
#include "core/program/iso/language/system_variables.h"
#include "core/program/iso/language/variables.h"

namespace feedscope::iso {

/// Reads the words of lines with variables, expressions and names, and runs their assignments.
class Statements : private Part {
 public:
  /// All outlive it.
  Statements(Context& context, Expression& expression, SystemVariables& system, Variables& variables)
      : Part(context), expression_(expression), system_(system), variables_(variables) {}

  /// Begins a line with more than plain words: everything before its first statement belongs to the words.
  /// Returns the text without comments, from that statement on.
  Scanner begin(const Block& line);
  /// Adds the words before the first statement to the block.
  void keep_words(const Block& line);
  /// Reads words and assignments up to the line's end. Returns false, with a report, if one is unreadable;
  /// the rest of the line is then skipped.
  bool read(Scanner& scan);
  /// Everything read, valid until the next begin().
  const Block& block() const { return block_; }
  /// True once a variable has been given a value.
  bool has_assigned() const { return has_assigned_; }

 private:
  struct Assignment {
    std::uint32_t number = 0;
    std::string name;  ///< empty: by number
    double value = 0;
    std::uint32_t column = 0;
  };

  std::string_view without_comments(const Block& line);
  void read_word(Scanner& scan);
  double read_value(Scanner& scan, bool& has_point);
  void read_assignment(Scanner& scan);
  void assign(const Assignment& assignment);

  Expression& expression_;
  SystemVariables& system_;
  Variables& variables_;
  Block block_;
  std::string text_;  ///< without comments
  std::vector<Assignment> assignments_;
  bool has_assigned_ = false;
};

/// Ignores the rest of the line.
inline void skip_rest(Scanner& scan) {
  scan.move_to(scan.text().size());
}

}  // namespace feedscope::iso
