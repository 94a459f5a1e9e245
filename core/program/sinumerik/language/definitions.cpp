#include "core/program/sinumerik/language/definitions.h"

#include <array>
#include <optional>
#include <utility>

#include "core/program/language/statement_table.h"
#include "core/program/sinumerik/language/scanning.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

namespace {

constexpr auto types = std::to_array<std::pair<std::string_view, Type>>({{"REAL", Type::real},
                                                                         {"INT", Type::integer},
                                                                         {"BOOL", Type::boolean},
                                                                         {"CHAR", Type::integer},
                                                                         {"STRING", Type::text},
                                                                         {"AXIS", Type::axis}});

/// Reads the next type, with the length of a text; none, with nothing taken, if there is none.
std::optional<Type> take_type(Scanner& scanner) {
  for (const auto& [name, type] : types) {
    if (scanner.take_name(name)) {
      if (type == Type::text && scanner.peek() == '[') {
        skip_brackets(scanner);
      }
      return type;
    }
  }
  return std::nullopt;
}

}  // namespace

bool Definitions::run(std::string_view name, Scanner& scanner) {
  static constexpr auto statements =
      std::to_array<StatementEntry<Definitions>>({{"DEF", &Definitions::run_def},
                                                  {"PROC", &Definitions::run_proc},
                                                  {"EXTERN", &Definitions::run_extern},
                                                  {"DEFINE", &Definitions::run_define}});
  return run_statement(*this, statements, name, scanner);
}

/// DEF REAL A=1, B[3], and DEF STRING[20] NAME.
void Definitions::run_def(Scanner& scanner) {
  for (const std::string_view scope : {"NCK", "CHAN", "SYNR", "SYNW", "SYNRW", "PHU"}) {
    scanner.take_name(scope);
  }
  const std::uint32_t column = scanner.column();
  if (scanner.take_name("FRAME")) {
    frames_.define(scanner);
    return;
  }
  const std::optional<Type> type = take_type(scanner);
  if (!type) {
    throw ReadFault{
        "definition", column, message(NC_("core", "{} is not a supported type"), in_quotes(scanner.rest())),
        NC_("core", "write REAL, INT, BOOL, CHAR, STRING, AXIS or FRAME; the variables are not defined")};
  }
  do {
    const std::uint32_t at = scanner.column();
    const std::string_view name = scanner.name();
    if (name.empty()) {
      throw ReadFault{"definition", at, NC_("core", "DEF without a name"),
                      NC_("core", "write the variable's name after its type")};
    }
    Variable variable = Variable::of(*type, values_.dimensions(scanner));
    if (scanner.take('=')) {
      assignments_.initialise(scanner, variable);
    }
    values_.variables().define(name, std::move(variable));
  } while (scanner.take(','));
}

void Definitions::run_define(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::string_view name = scanner.name();
  const bool complete = !name.empty() && scanner.take_name("AS") && !scanner.at_end();
  if (!complete) {
    throw ReadFault{"macro", column, NC_("core", "DEFINE needs a name, AS and words"),
                    NC_("core", "its name is called as a subprogram; write DEFINE NAME AS G0 X5")};
  }
  macros_.define(name, scanner.rest());
  skip_rest(scanner);
}

void Definitions::run_extern(Scanner& scanner) {
  scanner.name();
  if (scanner.peek() == '(') {
    skip_brackets(scanner);
  }
}

void Definitions::run_proc(Scanner& scanner) {
  Calls::Parameters* const parameters = calls_.parameters();
  if (parameters != nullptr) {
    parameters->returned.clear();
  }
  scanner.name();
  if (scanner.take('(')) {
    std::size_t position = 0;
    while (scanner.peek() != ')' && !scanner.at_end()) {
      read_parameter(scanner, position++);
      scanner.take(',');
    }
    require(scanner, ')');
  }
  while (!scanner.at_end()) {
    const std::string_view attribute = scanner.name();
    if (attribute.empty()) {
      throw ReadFault{"syntax", scanner.column(),
                      message(NC_("core", "{} after PROC is not an attribute"), in_quotes(scanner.rest())),
                      NC_("core", "write the parameters in brackets, then attributes such as SAVE")};
    }
    if (letters::same(attribute, "SAVE") && parameters != nullptr) {
      parameters->keeps_modes = true;
    }
  }
}

/// Argument of the call at a position; nullptr for none.
const Argument* Definitions::argument(std::size_t position) {
  const Calls::Parameters* const parameters = calls_.parameters();
  return parameters != nullptr && position < parameters->arguments.size() ? &parameters->arguments[position]
                                                                          : nullptr;
}

/// "REAL X", "VAR INT N", "REAL X=1".
void Definitions::read_parameter(Scanner& scanner, std::size_t position) {
  const bool by_reference = scanner.take_name("VAR");
  const std::uint32_t column = scanner.column();
  const std::optional<Type> type = take_type(scanner);
  const std::string_view name = scanner.name();
  if (!type || name.empty()) {
    throw ReadFault{"definition", column,
                    message(NC_("core", "{} is not a parameter"), in_quotes(scanner.rest())),
                    NC_("core", "write a type and a name")};
  }
  const Argument* const passed = argument(position);
  Variable variable = parameter_variable(scanner, *type, name, passed);
  bool given = scanner.take('=');
  if (given) {
    assignments_.initialise(scanner, variable);
  }
  if (passed != nullptr) {
    if (by_reference && !passed->variable.empty()) {
      calls_.parameters()->returned.emplace_back(std::string(name), passed->variable);
    }
    given = given || passed->number || passed->text;
    if (passed->number && !variable.is_text()) {
      variable.set(0, *passed->number);
    } else if (passed->text && variable.is_text()) {
      variable.texts[0] = *passed->text;
    }
  }
  if (!given && calls_.parameters() == nullptr) {
    report(Severity::warning, "unset-parameter", -1, column, [&] {
      return Text{message(NC_("core", "parameter {} has no value"), in_quotes(name)),
                  NC_("core", "0 is used; call the program with a value")};
    });
  }
  values_.variables().define(name, std::move(variable));
}

/// Variable of a parameter whose type and name have just been read. "A[3]" and "A[]" take all elements of the
/// array that is passed.
Variable Definitions::parameter_variable(Scanner& scanner, Type type, std::string_view name,
                                         const Argument* passed) {
  const std::uint32_t column = scanner.column();
  if (scanner.peek() != '[') {
    return Variable::of(type);
  }
  Scanner inside = scanner;
  inside.take('[');
  const bool open = inside.peek() == ']' || inside.peek() == ',';
  if (open) {
    skip_brackets(scanner);
  }
  Variable variable = open ? Variable::of(type) : Variable::of(type, values_.dimensions(scanner));
  if (passed == nullptr || !passed->array) {
    return variable;
  }
  const Variable& array = *passed->array;
  if (array.is_text() != variable.is_text() || (!open && array.count() != variable.count())) {
    throw ReadFault{"definition", column,
                    message(NC_("core", "array parameter {} has {} elements, the argument has {}"),
                            in_quotes(name), variable.count(), array.count()),
                    NC_("core", "pass an array of the same type and size")};
  }
  variable.size = open ? array.size : variable.size;
  variable.numbers = array.numbers;
  variable.texts = array.texts;
  return variable;
}

}  // namespace feedscope::sinumerik
