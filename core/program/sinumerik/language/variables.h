#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace feedscope::sinumerik {

enum class Type : std::uint8_t { real, integer, boolean, text, axis };

/// A variable or an array of up to three dimensions, as defined by DEF.
struct Variable {
  Type type = Type::real;
  std::array<std::size_t, 3> size{1, 1, 1};
  std::vector<double> numbers;     ///< real, integer, boolean
  std::vector<std::string> texts;  ///< text, axis

  static Variable of(Type type, const std::array<std::size_t, 3>& size = {1, 1, 1});

  std::size_t count() const { return size[0] * size[1] * size[2]; }
  bool is_text() const { return type == Type::text || type == Type::axis; }
  /// Rounded to the type.
  void set(std::size_t index, double value);
};

/// Values of a program's variables: R parameters for all, others by the program that defines them. A
/// subprogram sees its own and those of the main program.
class Variables {
 public:
  Variables() : levels_(1) {}

  /// R parameter; none: not set by the program.
  std::optional<double> r(int number) const;
  void set_r(int number, double value) { r_[number] = value; }

  /// nullptr if there is none.
  Variable* find(std::string_view name);
  /// The same for a name of one letter, in upper case. Controls have none; textbooks do.
  Variable* find_letter(char letter) {
    return (letters_ >> (letter - 'A') & 1U) != 0 ? find(std::string_view(&letter, 1)) : nullptr;
  }
  bool has_letters() const { return letters_ != 0; }
  /// Replaces one of the same name.
  Variable& define(std::string_view name, Variable variable);

  /// Begins and ends a subprogram.
  void enter() { levels_.emplace_back(); }
  void leave() { levels_.pop_back(); }

 private:
  std::uint32_t letters_ = 0;  ///< names of one letter that were ever defined
  std::map<int, double> r_;
  std::vector<std::map<std::string, Variable, std::less<>>> levels_;
};

/// Throws ReadFault "array-index": the array `name`, in quotes, of `size` elements has no element `index`.
[[noreturn]] void throw_no_element(const Message& name, std::uint32_t column, double index, std::size_t size);

}  // namespace feedscope::sinumerik
