// The part of SinumerikReader that defines variables and runs subprograms.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

namespace {

constexpr auto types = std::to_array<std::pair<std::string_view, Type>>({{"REAL", Type::real},
                                                                         {"INT", Type::integer},
                                                                         {"BOOL", Type::boolean},
                                                                         {"CHAR", Type::integer},
                                                                         {"STRING", Type::text},
                                                                         {"AXIS", Type::axis}});

/// The type that stands here, with the length of a text; none, and nothing taken, if none does.
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

/// Without folder and drive.
std::string_view file_name(std::string_view written) {
  return written.substr(written.find_last_of("/\\:") + 1);
}

/// "/_N_SPF_DIR/_N_NAME_SPF", "NAME.SPF" and "NAME" are one subprogram.
std::string plain_name(std::string_view written) {
  std::string name = upper_case(file_name(written));
  if (name.starts_with("_N_")) {
    name.erase(0, 3);
  }
  for (const std::string_view ending : {"_SPF", "_MPF", ".SPF", ".MPF"}) {
    if (name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
    }
  }
  return name;
}

bool is_cycle(std::string_view name) {
  constexpr auto beginnings = std::to_array<std::string_view>(
      {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE", "CONTPRON", "CONTDCON"});
  return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view beginning) {
    return letters::same(name.substr(0, beginning.size()), beginning);
  });
}

}  // namespace

/// DEF REAL A=1, B[3], and DEF STRING[20] NAME.
void SinumerikReader::run_def(Scanner& scanner) {
  for (const std::string_view scope : {"NCK", "CHAN", "SYNR", "SYNW", "SYNRW", "PHU"}) {
    scanner.take_name(scope);
  }
  const std::uint32_t column = scanner.column();
  if (scanner.take_name("FRAME")) {
    define_frames(scanner);
    return;
  }
  const std::optional<Type> type = take_type(scanner);
  if (!type) {
    throw ReadFault{"definition", column, fmt::format("{} is no type that is read", quoted(scanner.rest())),
                    "write REAL, INT, BOOL, CHAR, STRING, AXIS or FRAME; the variables are not defined"};
  }
  do {
    const std::uint32_t at = scanner.column();
    const std::string_view name = scanner.name();
    if (name.empty()) {
      throw ReadFault{"definition", at, "DEF without a name", "write the variable's name behind its type"};
    }
    Variable variable = Variable::of(*type, values_.dimensions(scanner));
    if (scanner.take('=')) {
      values_.initialise(scanner, variable);
    }
    values_.variables().define(name, std::move(variable));
  } while (scanner.take(','));
}

void SinumerikReader::run_define(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::string_view name = scanner.name();
  const bool complete = !name.empty() && scanner.take_name("AS") && !scanner.at_end();
  if (!complete) {
    throw ReadFault{"macro", column, "DEFINE without a name, AS and words",
                    "words by its name are taken for subprograms; write DEFINE NAME AS G0 X5"};
  }
  macros_.define(name, scanner.rest());
  scanner.move_to(scanner.text().size());
}

void SinumerikReader::run_proc(Scanner& scanner) {
  if (!scopes_.empty()) {
    scopes_.back().returned.clear();
  }
  scanner.name();
  if (scanner.take('(')) {
    std::size_t position = 0;
    while (scanner.peek() != ')' && !scanner.at_end()) {
      bind(scanner, position++);
      scanner.take(',');
    }
    require(scanner, ')');
  }
  while (!scanner.at_end()) {
    const std::string_view attribute = scanner.name();
    if (attribute.empty()) {
      throw ReadFault{"syntax", scanner.column(),
                      fmt::format("{} stands behind PROC", quoted(scanner.rest())),
                      "write the parameters in brackets, then attributes such as SAVE"};
    }
    if (letters::same(attribute, "SAVE") && !scopes_.empty()) {
      scopes_.back().saves = true;
    }
  }
}

/// One parameter: "REAL X", "VAR INT N", "REAL X=1".
void SinumerikReader::bind(Scanner& scanner, std::size_t position) {
  const bool by_reference = scanner.take_name("VAR");
  const std::uint32_t column = scanner.column();
  const std::optional<Type> type = take_type(scanner);
  const std::string_view name = scanner.name();
  if (!type || name.empty()) {
    throw ReadFault{"definition", column, fmt::format("{} is no parameter", quoted(scanner.rest())),
                    "write a type and a name"};
  }
  Variable variable = take_array(scanner, *type, position, name);
  bool given = scanner.take('=');
  if (given) {
    values_.initialise(scanner, variable);
  }
  if (!scopes_.empty() && position < scopes_.back().arguments.size()) {
    const Argument& argument = scopes_.back().arguments[position];
    if (by_reference && !argument.variable.empty()) {
      scopes_.back().returned.emplace_back(std::string(name), argument.variable);
    }
    given = given || argument.number || argument.text;
    if (argument.number && !variable.is_text()) {
      variable.set(0, *argument.number);
    } else if (argument.text && variable.is_text()) {
      variable.texts[0] = *argument.text;
    }
  }
  if (!given && scopes_.empty()) {
    report(Severity::warning, "unset-parameter", -1, column, [&] {
      return Text{fmt::format("the program waits for a value of {}", quoted(name)),
                  "taken as 0; call it from a program that gives the value"};
    });
  }
  values_.variables().define(name, std::move(variable));
}

/// The variable of a parameter whose type and name have just been read. "A[3]" and "A[]" take all elements of
/// the array that is passed.
Variable SinumerikReader::take_array(Scanner& scanner, Type type, std::size_t position,
                                     std::string_view name) {
  const std::uint32_t column = scanner.column();
  if (scanner.peek() != '[') {
    return Variable::of(type);
  }
  Scanner inside = scanner;
  inside.take('[');
  const bool open = inside.peek() == ']' || inside.peek() == ',';
  Variable variable;
  if (open) {
    skip_brackets(scanner);
    variable = Variable::of(type);
  } else {
    variable = Variable::of(type, values_.dimensions(scanner));
  }
  const bool passed = !scopes_.empty() && position < scopes_.back().arguments.size();
  const std::optional<Variable> array =
      passed ? scopes_.back().arguments[position].array : std::optional<Variable>();
  if (!array) {
    return variable;
  }
  if (array->is_text() != variable.is_text() || (!open && array->count() != variable.count())) {
    throw ReadFault{"definition", column,
                    fmt::format("the array parameter {} has {} elements, what is passed has {}", quoted(name),
                                variable.count(), array->count()),
                    "pass an array of the same type and size"};
  }
  variable.size = open ? array->size : variable.size;
  variable.numbers = array->numbers;
  variable.texts = array->texts;
  return variable;
}

void SinumerikReader::run_extern(Scanner& scanner) {
  scanner.name();
  if (scanner.peek() == '(') {
    skip_brackets(scanner);
  }
}

void SinumerikReader::run_ret(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('(') && !scanner.take(')')) {
    report(Severity::error, "unread-statement", 0, column, [] {
      return Text{"RET with a target for the jump back is not read",
                  "the program goes on behind the call; return without a target"};
    });
    scanner.move_to(scanner.text().size());
  }
  ends_ = true;
}

void SinumerikReader::run_call(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (!values_.text_follows(scanner)) {
    call_ = read_call(scanner);
    return;
  }
  call_ = SubprogramCall{
      .name = values_.read_text(scanner), .column = column, .arguments = {}, .bracketed = false};
}

/// A program from outside of the control, with its folder or without: EXTCALL("D:/PART.WPD/OP10.SPF").
void SinumerikReader::run_extcall(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (values_.text_follows(scanner) || scanner.peek() == '(') {
    call_ = SubprogramCall{
        .name = values_.read_text(scanner), .column = column, .arguments = {}, .bracketed = false};
  } else {
    call_ = read_call(scanner);
  }
}

void SinumerikReader::run_isocall(Scanner& scanner) {
  report(Severity::error, "unread-function", kind_of("ISOCALL"), scanner.column(), [] {
    return Text{"ISOCALL (call of a program in ISO dialect) is not read", "its motion is left out"};
  });
  scanner.move_to(scanner.text().size());
}

/// With a name: it is called behind every motion from now on; alone: no longer.
void SinumerikReader::run_mcall(Scanner& scanner) {
  modal_call_.reset();
  if (!scanner.at_end()) {
    modal_call_ = ModalCall{.call = read_call(scanner), .depth = call_depth()};
  }
}

SinumerikReader::SubprogramCall SinumerikReader::read_call(Scanner& scanner) {
  SubprogramCall call;
  call.column = scanner.column();
  call.name = std::string(scanner.name());
  if (call.name.empty()) {
    throw ReadFault{"syntax", call.column, fmt::format("{} is no subprogram", quoted(scanner.rest())),
                    "write the subprogram's name"};
  }
  call.bracketed = scanner.peek() == '(';
  if (call.bracketed) {
    call.arguments = read_arguments(scanner);
  }
  return call;
}

Arguments SinumerikReader::read_arguments(Scanner& scanner) {
  Arguments arguments;
  require(scanner, '(');
  if (scanner.take(')')) {
    return arguments;
  }
  do {
    Argument& argument = arguments.emplace_back();
    if (scanner.peek() == ',' || scanner.peek() == ')') {
      continue;
    }
    Scanner alone = scanner;
    const std::string_view name = alone.name();
    const bool only_name = !name.empty() && (alone.peek() == ',' || alone.peek() == ')');
    const Variable* const variable = only_name ? values_.variables().find(name) : nullptr;
    if (variable != nullptr) {
      argument.variable = upper_case(name);
      argument.array = variable->count() > 1 ? std::optional(*variable) : std::nullopt;
    }
    if (values_.text_follows(scanner)) {
      argument.text = values_.read_text(scanner);
    } else if (only_name && name.size() == 1 && variable == nullptr) {
      argument.text = upper_case(name);
      scanner = alone;
    } else {
      argument.number = values_.read_bounded(scanner);
    }
  } while (scanner.take(','));
  require(scanner, ')');
  return arguments;
}

void SinumerikReader::run_subprogram(const SubprogramCall& call, std::uint32_t times) {
  finish_spline();
  const std::string name = plain_name(call.name);
  for (const auto& text : {text_in_force(), main_text()}) {
    const ProgramIndex::Section* const section = index_of(*text).section(name);
    if (section != nullptr && !(section->main && call_depth() == 0 && text == text_in_force() &&
                                section == &index().section_of(line()))) {
      enter(call, text, section->first, times);
      return;
    }
  }
  const std::vector<std::string> files{name + ".SPF", name + ".MPF", "_N_" + name + "_SPF",
                                       "_N_" + name + "_MPF", std::string(file_name(call.name))};
  if (auto text = subprogram_files().find(files)) {
    enter(call, std::move(text), 1, times);
    return;
  }
  const bool cycle = is_cycle(name);
  report(Severity::error, cycle ? "unread-cycle" : "subprogram-missing", kind_of(name), call.column, [&] {
    return cycle ? Text{fmt::format("the cycle {} is not read", name), "its motion is left out"}
                 : Text{fmt::format("there is no subprogram {} beside the program",
                                    feedscope::quoted(call.name)),
                        "its motion is left out; put it beside the program or into the same file"};
  });
}

bool SinumerikReader::enter(const SubprogramCall& call, std::shared_ptr<const SourceText> text,
                            std::uint32_t line, std::uint32_t times) {
  Scope scope;
  scope.name = call.name;
  scope.arguments = call.arguments;
  scope.modal = modal_;
  scope.frames = frames_;
  scope.path_words = path_words_;
  if (!Reader::call(std::move(text), line, times)) {
    return false;
  }
  scope.ends_caller = ends_;
  ends_ = false;
  scopes_.push_back(std::move(scope));
  values_.variables().enter();
  return true;
}

}  // namespace feedscope
