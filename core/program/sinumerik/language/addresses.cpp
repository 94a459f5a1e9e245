#include "core/program/sinumerik/language/addresses.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/program/sinumerik/geometry/coordinate_value.h"
#include "core/program/text/message.h"

namespace feedscope::sinumerik {

namespace {

constexpr auto addresses = std::to_array<std::pair<std::string_view, Address>>(
    {{"CR", Address::cr},   {"AR", Address::ar},   {"TURN", Address::turn}, {"I1", Address::i1},
     {"J1", Address::j1},   {"K1", Address::k1},   {"AP", Address::ap},     {"RP", Address::rp},
     {"ANG", Address::ang}, {"RPL", Address::rpl}, {"PW", Address::pw},     {"PL", Address::pl},
     {"SD", Address::sd},   {"FB", Address::fb},   {"RND", Address::rnd},   {"RNDM", Address::rndm},
     {"CHF", Address::chf}, {"CHR", Address::chr}, {"FRC", Address::frc},   {"FRCM", Address::frcm}});

bool starts_number(char c) {
  return letters::is_digit(c) || c == '.' || c == '+' || c == '-';
}

}  // namespace

void Addresses::set(const Word& word, std::string_view written) {
  set(word.letter, {.value = word.value, .column = word.column, .reading = Reading::modal}, written);
}

void Addresses::set(char letter, const BlockWords::Value& value, std::string_view written) {
  switch (letter) {
    case 'N':
      return;
    case 'G':
      parts_.modal_words.apply_g(value.value, value.column, written);
      return;
    case 'M':
      parts_.modal_words.apply_m(value.value);
      return;
    case 'P':
      words_.set(Address::p, value);
      return;
    case 'L':
      set_call(value, written);
      return;
    default:
      break;
  }
  if (words_.has(letter)) {
    report(Severity::error, "duplicate-word", letter, value.column, [&] {
      return Text{message(NC_("core", "{} is programmed twice in this block"), letter),
                  message(NC_("core", "{} is used; remove the other"), in_quotes(written))};
    });
  }
  words_.set(letter, value);
}

/// L1 and L01 are different subprograms.
void Addresses::set_call(const BlockWords::Value& value, std::string_view written) {
  const std::string_view digits =
      written.substr(std::min(written.find_first_not_of(" \t", 1), written.size()));
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
    report(Severity::error, "subprogram-name", 'L', value.column, [&] {
      return Text{message(NC_("core", "{} does not name a subprogram"), in_quotes(written)),
                  NC_("core", "write its number with digits only, as in L12; nothing is called")};
    });
    return;
  }
  parts_.calls.set("L" + std::string(digits), value.column);
}

bool Addresses::run_address(Scanner& scanner, std::string_view name, std::uint32_t column) {
  const auto found = std::find_if(addresses.begin(), addresses.end(),
                                  [&](const auto& entry) { return letters::same(entry.first, name); });
  if (found == addresses.end() || !scanner.take('=')) {
    return false;
  }
  words_.set(found->second, read_coordinate(parts_.values, scanner, column));
  return true;
}

void Addresses::run_numbered(Scanner& scanner, std::string_view name, std::uint32_t column) {
  if (run_address(scanner, name, column)) {
    return;
  }
  const char letter = letters::to_upper(name[0]);
  if (std::string_view("SMHTDFG").find(letter) != std::string_view::npos) {
    // Address of a spindle or channel; the path depends on spindle S1.
    const bool value = scanner.peek() == '=';
    Scanner ahead = scanner;
    parts_.values.skip(scanner);
    if (letter == 'S' && value && ahead.take('=') && name == "S1") {
      words_.set('S', {.value = parts_.values.read(ahead), .column = column, .reading = Reading::modal});
    }
    return;
  }
  if (scanner.peek() == '[') {
    skip_brackets(scanner);
  }
  require(scanner, '=');
  const BlockWords::Value value = read_coordinate(parts_.values, scanner, column);
  // The machine's axis names, as in G74 and G75: "Z1=0".
  const bool names_axis =
      functions_.machine_axes != nullptr && letter >= 'X' && letter <= 'Z' && name.substr(1) == "1";
  if (names_axis) {
    words_.set(letter, value);
  } else {
    parts_.other_axes.move(name, value);
  }
}

bool Addresses::run_letter(Scanner& scanner) {
  Values& values = parts_.values;
  const std::uint32_t column = scanner.column();
  const std::size_t from = scanner.at();
  const char letter = letters::to_upper(scanner.peek());
  scanner.take(letter);
  const char next = scanner.peek();
  const bool assigned = next == '=';
  if (Variable* const variable = assigned || next == '[' ? values.variables().find_letter(letter) : nullptr) {
    parts_.assignments.assign(scanner, *variable, std::string_view(&letter, 1));
    return true;
  }
  if (letter == 'R' && next == '[') {
    return parts_.assignments.assign_r(scanner);
  }
  const bool is_address = letter >= 'A' && letter <= 'Z' && next != '[';
  if (!is_address || !(assigned || starts_number(next))) {
    // Address of a spindle: "S[2]=1000".
    if (next != '[' || std::string_view("SMHTD").find(letter) == std::string_view::npos) {
      scanner.move_to(from);
      return false;
    }
    values.skip(scanner);
    return true;
  }
  if (assigned) {
    scanner.take('=');
  }
  if (assigned && letter == 'T' && values.text_follows(scanner)) {
    parts_.compensation.choose_tool(values.read_text(scanner));
    return true;
  }
  if (assigned && scanner.take_name("QU")) {
    skip_brackets(scanner);
    return true;
  }
  const BlockWords::Value value =
      assigned ? read_coordinate(values, scanner, column)
               : BlockWords::Value{.value = Values::bounded(values.read_operand(scanner), column),
                                   .column = column,
                                   .reading = Reading::modal};
  set(letter, value, scanner.text().substr(from, scanner.at() - from));
  return true;
}

}  // namespace feedscope::sinumerik
