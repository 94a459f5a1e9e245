#include "core/program/heidenhain/heidenhain_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Statements that are known and not followed.
struct UnreadStatement {
  std::string_view name;
  Severity severity = Severity::error;
  std::string_view subject;
  std::string_view effect;
};

constexpr std::string_view positions_missing = "the motion it stands for is missing";

constexpr auto unread_statements = std::to_array<UnreadStatement>({
    {"PLANE", Severity::error, "tilted working plane of this form", "the path is shown untilted"},
    {"FUNCTION", Severity::info, "function of the machine", "the path is shown as programmed"},
    {"POLARKIN", Severity::error, "polar kinematics", "the path is shown as programmed"},
    {"FL", Severity::error, "free contour", positions_missing},
    {"FLT", Severity::error, "free contour", positions_missing},
    {"FC", Severity::error, "free contour", positions_missing},
    {"FCT", Severity::error, "free contour", positions_missing},
    {"FPOL", Severity::error, "free contour", positions_missing},
    {"FSELECT", Severity::error, "free contour", positions_missing},
    {"SPL", Severity::error, "spline", positions_missing},
    {"TCH", Severity::warning, "touch probe cycle", positions_missing},
    {"MODE", Severity::error, "another kind of machining", "its path is shown as if it were milling"},
    {"SEL", Severity::warning, "selected table, pattern or program", "what it selects is not known"},
    {"CONTOUR", Severity::error, "contour definition", positions_missing},
    {"OPEN", Severity::info, "file", "it does not change the path"},
});

const UnreadStatement* find_unread(std::string_view name) {
  const auto known = std::find_if(unread_statements.begin(), unread_statements.end(),
                                  [name](const UnreadStatement& s) { return letters::same(s.name, name); });
  return known == unread_statements.end() ? nullptr : &*known;
}

/// Behind the number of the block and the sign that hides it; true if it is hidden.
bool skip_number(Scanner& scanner) {
  const bool before = scanner.take('/');
  if (letters::to_upper(scanner.peek()) == 'N' && letters::is_digit(scanner.peek_at(1))) {
    scanner.take('N');
  }
  scanner.skip_digits();
  const bool behind = scanner.take('/');
  scanner.peek();
  return before || behind;
}

/// Empty, a heading, or a setup sheet's line that a CAM system has left before the program.
bool is_no_block(Scanner& scanner) {
  return scanner.at_end() || scanner.peek() == '*' || scanner.peek() == '(';
}

std::string_view keyword(Scanner& scanner) {
  scanner.peek();
  const std::size_t from = scanner.at();
  std::size_t length = 0;
  while (letters::is_letter(scanner.peek_at(length))) {
    ++length;
  }
  scanner.move_to(from + length);
  return scanner.text().substr(from, length);
}

bool is_parameter_name(std::string_view name, char after) {
  return letters::is_digit(after) && (letters::same(name, "Q") || letters::same(name, "QL") ||
                                      letters::same(name, "QR") || letters::same(name, "QS"));
}

/// "X+50 R+ FMAX", "IZ-5", "M3", "F500": the words of a block without a name.
bool starts_words(std::string_view name) {
  constexpr std::string_view first = "XYZABCUVWIMFR";
  return name.size() <= 2 && first.find(letters::to_upper(name.front())) != std::string_view::npos;
}

}  // namespace

const HeidenhainReader::Statement* HeidenhainReader::find_statement(std::string_view name) {
  using R = HeidenhainReader;
  static constexpr auto statements = std::to_array<Statement>({
      {"L", &R::line},
      {"CC", &R::pole},
      {"C", &R::center_arc},
      {"CR", &R::radius_arc},
      {"CT", &R::tangent_arc},
      {"LP", &R::polar_line},
      {"CP", &R::polar_arc},
      {"CTP", &R::polar_tangent_arc},
      {"LN", &R::line},
      {"RND", &R::rounding},
      {"CHF", &R::chamfer},
      {"APPR", &R::approach},
      {"DEP", &R::departure},
      {"BEGIN", &R::begin},
      {"END", &R::end},
      {"BLK", &R::blank_form},
      {"TOOL", &R::tool},
      {"LBL", &R::label_statement},
      {"CALL", &R::call_statement},
      {"STOP", &R::stop},
      {"FN", &R::function},
      {"CYCL", &R::cycle},
      {"CYCLE", &R::cycle},
      {"TRANS", &R::transformation},
      {"DECLARE", &R::declaration},
      {"PLANE", &R::plane_statement},
      {"PATTERN", &R::pattern},
      {"FUNCTION", &R::function_statement},
      {"GLOBAL", &R::global_definition},
      {"PRESET", &R::preset},
      {"SEL", &R::select},
  });
  const auto found = std::find_if(statements.begin(), statements.end(),
                                  [name](const Statement& s) { return letters::same(s.name, name); });
  return found != statements.end() ? &*found : nullptr;
}

void HeidenhainReader::run_statement(std::string_view statement) {
  Scanner scanner(statement);
  const bool hidden = skip_number(scanner);
  if (is_no_block(scanner) || (hidden && options().skip_deleted_blocks)) {
    return;
  }
  count_block();
  const std::size_t start = scanner.at();
  const std::uint32_t column = scanner.column();
  const std::string_view name = keyword(scanner);
  if (name.empty()) {
    report_unknown(statement, column);
  } else if (const Statement* known = find_statement(name)) {
    (this->*known->run)(scanner, column);
  } else if (is_parameter_name(name, scanner.peek_at(0))) {
    scanner.move_to(start);
    assign(scanner);
  } else if (find_unread(name) != nullptr) {
    report_unread(name, statement, column);
  } else if (starts_words(name)) {
    scanner.move_to(start);
    run_path(PathKind::line, words(scanner));
  } else {
    report_unknown(statement, column);
  }
}

void HeidenhainReader::report_unread(std::string_view name, std::string_view statement,
                                     std::uint32_t column) {
  const UnreadStatement* const known = find_unread(name);
  if (known == nullptr) {
    report_unknown(statement, column);
    return;
  }
  if (std::find(said_.begin(), said_.end(), known->name) != said_.end()) {
    return;
  }
  said_.push_back(known->name);
  report(known->severity, "unread-statement", static_cast<int>(known - unread_statements.data()) + 1, column,
         [&] {
           return Text{fmt::format("{} ({}) is not supported", known->name, known->subject),
                       fmt::format("{}; reported once", known->effect)};
         });
}

void HeidenhainReader::report_unknown(std::string_view statement, std::uint32_t column) {
  report(Severity::error, "unknown-statement", 0, column, [&] {
    return Text{fmt::format("{} is not a statement of this dialect", quoted(statement.substr(column - 1))),
                "it is skipped; if the program is another dialect's, name it with --dialect"};
  });
}

std::uint32_t HeidenhainReader::first_word(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_number(scanner);
  const std::uint32_t column = scanner.column();
  const bool counts = !is_no_block(scanner) && !letters::same(keyword(scanner), "END");
  return counts ? column : 0;
}

std::string HeidenhainReader::label_on(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_number(scanner);
  if (!letters::same(keyword(scanner), "LBL") || scanner.at_end()) {
    return {};
  }
  std::string label = this->label(scanner);
  return label == "0" ? std::string() : label;
}

void HeidenhainReader::line(Scanner& scanner, std::uint32_t) {
  run_path(PathKind::line, words(scanner));
}

void HeidenhainReader::pole(Scanner& scanner, std::uint32_t) {
  set_pole(words(scanner));
}

void HeidenhainReader::center_arc(Scanner& scanner, std::uint32_t column) {
  run_arc(PathKind::center_arc, scanner, column);
}

void HeidenhainReader::radius_arc(Scanner& scanner, std::uint32_t column) {
  run_arc(PathKind::radius_arc, scanner, column);
}

void HeidenhainReader::tangent_arc(Scanner& scanner, std::uint32_t column) {
  run_arc(PathKind::tangent_arc, scanner, column);
}

void HeidenhainReader::polar_line(Scanner& scanner, std::uint32_t column) {
  run_arc(PathKind::polar_line, scanner, column);
}

void HeidenhainReader::polar_arc(Scanner& scanner, std::uint32_t column) {
  run_arc(PathKind::polar_arc, scanner, column);
}

void HeidenhainReader::polar_tangent_arc(Scanner& scanner, std::uint32_t column) {
  run_arc(PathKind::polar_tangent_arc, scanner, column);
}

void HeidenhainReader::run_arc(PathKind kind, Scanner& scanner, std::uint32_t column) {
  MotionWords words = this->words(scanner);
  words.first_column = words.first_column == 0 ? column : words.first_column;
  run_path(kind, words);
}

void HeidenhainReader::rounding(Scanner& scanner, std::uint32_t column) {
  const MotionWords words = this->words(scanner);
  if (!words.radius) {
    throw ReadFault{"corner", column, "RND without a radius R", "the corner stays sharp"};
  }
  run_corner(true, *words.radius, words, column);
}

void HeidenhainReader::chamfer(Scanner& scanner, std::uint32_t column) {
  const double side = to_mm(formulas().read_value(scanner));
  run_corner(false, side, words(scanner), column);
}

void HeidenhainReader::approach(Scanner& scanner, std::uint32_t column) {
  const auto [kind, polar] = approach_name(scanner);
  run_approach(kind, polar, words(scanner), column);
}

void HeidenhainReader::departure(Scanner& scanner, std::uint32_t column) {
  const auto [kind, polar] = approach_name(scanner);
  run_departure(kind, polar, words(scanner), column);
}

std::pair<ApproachKind, bool> HeidenhainReader::approach_name(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  std::string_view name = scanner.name();
  const bool polar = !name.empty() && letters::to_upper(name.front()) == 'P';
  name.remove_prefix(polar ? 1 : 0);
  constexpr std::array<std::string_view, 4> names{"LT", "LN", "CT", "LCT"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (letters::same(name, names[i])) {
      return {static_cast<ApproachKind>(i), polar};
    }
  }
  throw ReadFault{"approach", column, fmt::format("{} is no kind of approach or departure", quoted(name)),
                  "it is left out; write LT, LN, CT, LCT or the polar forms with P before them"};
}

}  // namespace feedscope
