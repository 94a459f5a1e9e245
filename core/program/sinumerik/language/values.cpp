#include "core/program/sinumerik/language/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/program/sinumerik/language/grammar.h"
#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

namespace {

constexpr std::size_t max_elements = 100'000;
constexpr int max_r = 32'535;
constexpr double max_value = 1e9;

/// Names of numbers in the control's cycles.
constexpr auto constants = std::to_array<std::pair<std::string_view, double>>({{"TRUE", 1},
                                                                               {"FALSE", 0},
                                                                               {"_OFF", 0},
                                                                               {"_FINISH", 1},
                                                                               {"_SEMIFIN", 2},
                                                                               {"_ROUGH", 3},
                                                                               {"_ORI_FINISH", 11},
                                                                               {"_ORI_SEMIFIN", 12},
                                                                               {"_ORI_ROUGH", 13},
                                                                               {"_PRECISION", 4},
                                                                               {"_ORI_PRECISION", 14}});

struct Level {
  int& depth;
  explicit Level(int& d) : depth(++d) {}
  ~Level() { --depth; }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;
};

}  // namespace

Values::Values(const PathWriter& path, Warn warn)
    : ExpressionReader(grammar()), path_(path), warn_(std::move(warn)) {}

std::optional<double> Values::variable(Scanner& scanner) {
  const char next = scanner.peek();
  if (next == '\'') {
    return quoted_number(scanner);
  }
  if (text_follows(scanner)) {
    return text_comparison(scanner);
  }
  if (next == '$') {
    return system_variable(scanner);
  }
  const std::uint32_t column = scanner.column();
  if (letters::to_upper(next) == 'R') {
    Scanner behind = scanner;
    behind.take('R');
    if (const std::optional<int> number = r_number(behind)) {
      scanner = behind;
      return r_value(*number, column);
    }
  }
  return named(scanner);
}

std::optional<double> Values::named(Scanner& scanner) {
  const std::size_t before = scanner.at();
  const std::string_view name = scanner.name();
  if (name.empty()) {
    return std::nullopt;
  }
  if (const Variable* const found = variables_.find(name); found != nullptr && !found->is_text()) {
    return found->numbers.at(element(scanner, *found, name));
  }
  if (letters::same(name, "BOUND")) {
    return bound(scanner);
  }
  if (letters::same(name, "ISVAR")) {
    require(scanner, '(');
    const std::string asked = read_text(scanner);
    require(scanner, ')');
    return variables_.find(std::string_view(asked).substr(0, asked.find('['))) != nullptr ? 1 : 0;
  }
  for (const auto& [constant, value] : constants) {
    if (letters::same(name, constant)) {
      return value;
    }
  }
  const bool is_function = scanner.peek() == '(';
  scanner.move_to(before);
  if (!is_function) {
    throw ReadFault{
        "unknown-name", scanner.column(),
        message(NC_("core", "the program does not define {}"), feedscope::in_quotes(std::string(name))),
        message(NC_("core",
                    "the block does not move; define data of the machine (GUD) at the program's top, \"DEF "
                    "REAL {}=\""),
                name)};
  }
  return std::nullopt;
}

double Values::bound(Scanner& scanner) {
  require(scanner, '(');
  const double least = read(scanner);
  require(scanner, ',');
  const double most = read(scanner);
  require(scanner, ',');
  const double value = read(scanner);
  require(scanner, ')');
  return std::max(least, std::min(most, value));
}

std::optional<int> Values::r_number(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  double number = 0;
  if (scanner.peek_at(0) == '[') {
    scanner.take('[');
    number = std::floor(read(scanner) + 0.5);
    require(scanner, ']');
  } else {
    const std::string_view rest = scanner.text().substr(scanner.at());
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits == 0 || (digits < rest.size() && letters::is_name_part(rest[digits]))) {
      return std::nullopt;
    }
    std::from_chars(rest.data(), rest.data() + digits, number);
    scanner.move_to(scanner.at() + digits);
  }
  if (!(number >= 0 && number <= max_r)) {
    throw ReadFault{"array-index", column,
                    message(NC_("core", "R{} is not an R parameter from R0 to R{}"), number, max_r),
                    NC_("core", "correct the number")};
  }
  return static_cast<int>(number);
}

double Values::r_value(int number, std::uint32_t column) {
  const std::optional<double> value = variables_.r(number);
  if (!value) {
    warn_("unset-parameter", number, column,
          {message(NC_("core", "R{} is used before the program sets it"), number),
           NC_("core", "0 is used; the control has a value of its own")});
  }
  return value.value_or(0);
}

double Values::quoted_number(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  scanner.take('\'');
  const char kind = letters::to_upper(scanner.peek());
  const int base = kind == 'H' ? 16 : 2;
  std::uint32_t value = 0;
  const std::string_view rest = scanner.text().substr(std::min(scanner.at() + 1, scanner.text().size()));
  const auto [stop, status] = std::from_chars(rest.data(), rest.data() + rest.size(), value, base);
  if ((kind != 'H' && kind != 'B') || status != std::errc() || stop == rest.data() + rest.size() ||
      *stop != '\'') {
    throw ReadFault{
        "malformed-number", column,
        message(NC_("core", "{} has no valid number"), in_quotes(scanner.text().substr(column - 1))),
        NC_("core", "write 'H1F' or 'B101'")};
  }
  scanner.move_to(static_cast<std::size_t>(stop - scanner.text().data()) + 1);
  return value;
}

double Values::system_variable(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  scanner.take('$');
  const std::string_view name = scanner.name();
  if (letters::same(name, "PI")) {
    return units::pi;
  }
  Scanner index = scanner;
  if (scanner.peek() == '[') {
    skip_brackets(scanner);
  }
  const bool of_position = letters::same(name, "P_EP") || letters::same(name, "AA_IW");
  if (of_position && index.take('[')) {
    const std::string_view axis = index.name();
    if (axis.size() == 1 && letters::to_upper(axis[0]) >= 'X' && letters::to_upper(axis[0]) <= 'Z') {
      return path_.position()[letters::to_upper(axis[0]) - 'X'];
    }
  }
  if (is_timer(name)) {
    return 0;
  }
  warn_(
      "system-variable", kind_of(name), column,
      {message(NC_("core", "{} is a control-internal value"), feedscope::in_quotes("$" + std::string(name))),
       NC_("core", "0 is used; the control may run another path")});
  return 0;
}

bool Values::text_follows(Scanner scanner) {
  if (scanner.peek() == '"') {
    return true;
  }
  const std::string_view name = scanner.name();
  const bool may_be = name.size() > 1 || (!name.empty() && variables_.has_letters());
  const Variable* const found = may_be ? variables_.find(name) : nullptr;
  return found != nullptr && found->is_text();
}

std::optional<double> Values::text_comparison(Scanner& scanner) {
  const std::string first = read_text(scanner);
  const std::uint32_t column = scanner.column();
  const bool equal = scanner.take("==");
  if (!equal && !scanner.take("<>")) {
    throw ReadFault{"expression", column,
                    message(NC_("core", "text {} is not a number"), feedscope::in_quotes(first)),
                    NC_("core", "compare texts with == or <>")};
  }
  return (first == read_text(scanner)) == equal ? 1 : 0;
}

double Values::read_bounded(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  return bounded(read(scanner), column);
}

std::optional<double> Values::plain_number(Scanner& scanner) {
  scanner.peek();
  const std::string_view rest = scanner.text().substr(std::min(scanner.at(), scanner.text().size()));
  const std::size_t sign = !rest.empty() && (rest[0] == '-' || rest[0] == '+') ? 1 : 0;
  if (rest.size() <= sign || !(letters::is_digit(rest[sign]) || rest[sign] == '.')) {
    return std::nullopt;
  }
  double number = 0;
  const char* const end = rest.data() + rest.size();
  const auto [stop, status] = std::from_chars(rest.data() + sign, end, number, std::chars_format::fixed);
  if (status != std::errc() || !(number <= max_value)) {
    return std::nullopt;
  }
  Scanner behind = scanner;
  behind.move_to(scanner.at() + static_cast<std::size_t>(stop - rest.data()));
  const char next = behind.peek();
  const char after = behind.peek_at(1);
  const bool word = letters::is_letter(next) && (letters::is_digit(after) || after == '-' || after == '+' ||
                                                 after == '.' || after == '=');
  if (next != '\0' && !word) {
    return std::nullopt;
  }
  scanner = behind;
  return rest[0] == '-' ? -number : number;
}

double Values::bounded(double value, std::uint32_t column) {
  if (!(std::abs(value) <= max_value)) {
    throw ReadFault{"number-range", column,
                    message(NC_("core", "value {} is above the largest number, 1000000000"), value),
                    NC_("core", "the block does not move; correct the expression")};
  }
  return value;
}

std::string Values::read_text(Scanner& scanner) {
  std::string text = text_operand(scanner);
  while (scanner.take("<<")) {
    text += text_operand(scanner);
  }
  return text;
}

std::string Values::text_operand(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('(')) {
    constexpr int deepest = 100;
    if (text_depth_ >= deepest) {
      throw ReadFault{"expression", column, NC_("core", "the text is nested more than 100 deep"),
                      NC_("core", "remove brackets")};
    }
    const Level level(text_depth_);
    std::string text = read_text(scanner);
    require(scanner, ')');
    return text;
  }
  if (scanner.peek() == '"') {
    const std::size_t from = scanner.at() + 1;
    const std::size_t to = scanner.text().find('"', from);
    if (to == std::string_view::npos) {
      throw ReadFault{"syntax", column, NC_("core", "the text is not closed"),
                      NC_("core", "add the closing quotation mark")};
    }
    scanner.move_to(to + 1);
    return std::string(scanner.text().substr(from, to - from));
  }
  if (text_follows(scanner)) {
    const std::string_view name = scanner.name();
    const Variable& found = *variables_.find(name);
    return found.texts.at(element(scanner, found, name));
  }
  return fmt::format("{}", read_operand(scanner));
}

std::array<std::size_t, 3> Values::dimensions(Scanner& scanner) {
  std::array<std::size_t, 3> size{1, 1, 1};
  if (!scanner.take('[')) {
    return size;
  }
  const std::uint32_t column = scanner.column();
  std::size_t count = 1;
  for (std::size_t& dimension : size) {
    const double number = std::floor(read(scanner) + 0.5);
    if (!(number >= 1 && number * static_cast<double>(count) <= static_cast<double>(max_elements))) {
      throw ReadFault{"array-size", column,
                      message(NC_("core", "{} is not a number of array elements from 1 to {}"),
                              number * static_cast<double>(count), max_elements),
                      NC_("core", "correct the size")};
    }
    dimension = static_cast<std::size_t>(number);
    count *= dimension;
    if (!scanner.take(',')) {
      break;
    }
  }
  require(scanner, ']');
  return size;
}

std::size_t Values::element(Scanner& scanner, const Variable& variable, std::string_view name) {
  if (!scanner.take('[')) {
    return 0;
  }
  std::size_t flat = 0;
  for (std::size_t i = 0; i < variable.size.size(); ++i) {
    const bool given = i == 0 || scanner.take(',');
    const std::uint32_t column = scanner.column();
    const double index = given ? std::floor(read(scanner) + 0.5) : 0;
    if (!(index >= 0 && index < static_cast<double>(variable.size[i]))) {
      throw_no_element(Message::as_written(feedscope::in_quotes(name)), column, index, variable.size[i]);
    }
    flat = flat * variable.size[i] + static_cast<std::size_t>(index);
  }
  require(scanner, ']');
  return flat;
}

void Values::skip(Scanner& scanner) {
  while (scanner.peek() == '[' || scanner.peek() == '(') {
    skip_brackets(scanner);
  }
  if (!scanner.take('=')) {
    return;
  }
  while (!scanner.at_end()) {
    const char c = scanner.peek();
    if (c == '(' || c == '[') {
      skip_brackets(scanner);
    } else if (c == '"') {
      read_text(scanner);
    } else {
      scanner.move_to(scanner.at() + 1);
    }
    if (letters::is_blank(scanner.peek_at(0))) {
      break;
    }
  }
}

}  // namespace feedscope::sinumerik
