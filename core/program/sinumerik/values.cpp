#include "core/program/sinumerik/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/program/sinumerik/grammar.h"
#include "core/program/sinumerik/names.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

namespace {

constexpr std::size_t most_elements = 100'000;
constexpr int most_r = 32'535;
constexpr double most_value = 1e9;

/// Names that the control's cycles give to numbers.
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

[[noreturn]] void throw_index(std::string_view name, std::uint32_t column, double index, std::size_t size) {
  throw ReadFault{"array-index", column,
                  fmt::format("{} has no element {}, its indices go up to {}", quoted(name), index, size - 1),
                  "correct the index or the size in DEF"};
}

}  // namespace

void require(Scanner& scanner, char c) {
  const std::uint32_t column = scanner.column();
  if (!scanner.take(c)) {
    throw ReadFault{"syntax", column, fmt::format("\"{}\" is missing here", c),
                    "correct the statement; the block does not move"};
  }
}

void skip_brackets(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  int depth = 0;
  bool inside_text = false;
  for (std::size_t at = scanner.at(); at < scanner.text().size(); ++at) {
    const char c = scanner.text()[at];
    inside_text = c == '"' ? !inside_text : inside_text;
    depth += !inside_text && (c == '(' || c == '[') ? 1 : 0;
    depth -= !inside_text && (c == ')' || c == ']') ? 1 : 0;
    if (depth == 0 && !inside_text) {
      scanner.move_to(at + 1);
      return;
    }
  }
  throw ReadFault{"syntax", column, "the bracket is not closed",
                  "correct the statement; the block does not move"};
}

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
    throw ReadFault{"unknown-name", scanner.column(),
                    fmt::format("the program does not define {}", feedscope::quoted(std::string(name))),
                    "the block does not move; data that only the machine has (GUD) can be defined at the "
                    "program's top, DEF REAL " +
                        std::string(name) + "="};
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
  if (!(number >= 0 && number <= most_r)) {
    throw ReadFault{"array-index", column,
                    fmt::format("R{} is no R parameter, they go from R0 to R{}", number, most_r),
                    "correct the number"};
  }
  return static_cast<int>(number);
}

double Values::r_value(int number, std::uint32_t column) {
  const std::optional<double> value = variables_.r(number);
  if (!value) {
    warn_("unset-parameter", number, column,
          {fmt::format("R{} is read before the program sets it", number),
           "taken as 0; the control has a value of its own"});
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
    throw ReadFault{"malformed-number", column,
                    fmt::format("{} has no readable number", quoted(scanner.text().substr(column - 1))),
                    "write 'H1F' or 'B101'"};
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
  warn_("system-variable", kind_of(name), column,
        {fmt::format("{} is known to the machine only", feedscope::quoted("$" + std::string(name))),
         "taken as 0"});
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
    throw ReadFault{"expression", column, fmt::format("the text {} is no number", feedscope::quoted(first)),
                    "compare texts by == or <>"};
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
  if (status != std::errc() || !(number <= most_value)) {
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
  if (!(std::abs(value) <= most_value)) {
    throw ReadFault{"number-range", column,
                    fmt::format("the value {} is beyond the largest number, 1000000000", value),
                    "the block does not move; correct the expression"};
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
      throw ReadFault{"expression", column, "the text is nested more than 100 deep", "leave out brackets"};
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
      throw ReadFault{"syntax", column, "the text is not closed", "add the closing quotation mark"};
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
    if (!(number >= 1 && number * static_cast<double>(count) <= static_cast<double>(most_elements))) {
      throw ReadFault{"array-size", column,
                      fmt::format("an array of {} elements is not within 1 to {}",
                                  number * static_cast<double>(count), most_elements),
                      "correct the size"};
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
      throw_index(name, column, index, variable.size[i]);
    }
    flat = flat * variable.size[i] + static_cast<std::size_t>(index);
  }
  require(scanner, ']');
  return flat;
}

void Values::assign(Scanner& scanner, Variable& variable, std::string_view name) {
  const std::size_t first = element(scanner, variable, name);
  require(scanner, '=');
  if (scanner.take_name("SET")) {
    set_list(scanner, variable, first);
  } else if (scanner.take_name("REP")) {
    repeat_one(scanner, variable, first);
  } else {
    set_one(scanner, variable, first);
  }
}

void Values::initialise(Scanner& scanner, Variable& variable) {
  if (scanner.take_name("SET") || (variable.count() > 1 && scanner.peek() == '(')) {
    set_list(scanner, variable, 0);
  } else if (scanner.take_name("REP")) {
    repeat_one(scanner, variable, 0);
  } else {
    set_one(scanner, variable, 0);
    copy_on(variable, 0, static_cast<double>(variable.count()));
  }
}

void Values::set_list(Scanner& scanner, Variable& variable, std::size_t first) {
  require(scanner, '(');
  std::size_t index = first;
  do {
    if (index >= variable.count()) {
      throw_index("the array", scanner.column(), static_cast<double>(index), variable.count());
    }
    if (scanner.peek() != ',' && scanner.peek() != ')') {
      set_one(scanner, variable, index);
    }
    ++index;
  } while (scanner.take(','));
  require(scanner, ')');
}

void Values::repeat_one(Scanner& scanner, Variable& variable, std::size_t first) {
  require(scanner, '(');
  set_one(scanner, variable, first);
  double count = static_cast<double>(variable.count());
  if (scanner.take(',')) {
    count = std::min(count, read(scanner));
  }
  require(scanner, ')');
  copy_on(variable, first, count);
}

void Values::copy_on(Variable& variable, std::size_t first, double count) {
  for (std::size_t i = first + 1; i < variable.count() && static_cast<double>(i - first) < count; ++i) {
    if (variable.is_text()) {
      variable.texts[i] = variable.texts[first];
    } else {
      variable.numbers[i] = variable.numbers[first];
    }
  }
}

LoopCounter Values::read_counter(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  Scanner behind = scanner;
  if (behind.take('R')) {
    if (const std::optional<int> number = r_number(behind)) {
      scanner = behind;
      return {.r = *number, .variable = nullptr, .element = 0};
    }
  }
  const std::string_view name = scanner.name();
  Variable* const found = variables_.find(name);
  if (found == nullptr || found->is_text()) {
    throw ReadFault{"syntax", column, fmt::format("FOR does not count with {}", quoted(name)),
                    "write an R parameter or a variable defined by DEF INT"};
  }
  return {.r = -1, .variable = found, .element = element(scanner, *found, name)};
}

double Values::get(const LoopCounter& counter) const {
  return counter.r >= 0 ? variables_.r(counter.r).value_or(0) : counter.variable->numbers.at(counter.element);
}

void Values::set(const LoopCounter& counter, double value) {
  if (counter.r >= 0) {
    variables_.set_r(counter.r, value);
  } else {
    counter.variable->set(counter.element, value);
  }
}

void Values::set_one(Scanner& scanner, Variable& variable, std::size_t index) {
  if (!variable.is_text()) {
    variable.set(index, read(scanner));
  } else if (variable.type == Type::axis && !text_follows(scanner)) {
    variable.texts.at(index) = upper_case(scanner.name());
  } else {
    variable.texts.at(index) = read_text(scanner);
  }
}

}  // namespace feedscope::sinumerik
