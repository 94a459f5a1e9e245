#include "core/program/sinumerik/language/calls.h"

#include <algorithm>
#include <array>

#include "core/program/language/statement_table.h"
#include "core/program/sinumerik/language/names.h"
#include "core/program/sinumerik/language/scanning.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

namespace {

bool is_cycle(std::string_view name) {
  constexpr auto beginnings = std::to_array<std::string_view>(
      {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE", "CONTPRON", "CONTDCON"});
  return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view beginning) {
    return letters::same(name.substr(0, beginning.size()), beginning);
  });
}

}  // namespace

bool Calls::run(std::string_view name, Scanner& scanner) {
  static constexpr auto statements = std::to_array<StatementEntry<Calls>>({{"RET", &Calls::run_ret},
                                                                           {"CALL", &Calls::run_call},
                                                                           {"PCALL", &Calls::run_call},
                                                                           {"EXTCALL", &Calls::run_extcall},
                                                                           {"ISOCALL", &Calls::run_isocall},
                                                                           {"MCALL", &Calls::run_mcall}});
  return run_statement(*this, statements, name, scanner);
}

void Calls::set(std::string name, std::uint32_t column) {
  call_ = SubprogramCall{.name = std::move(name), .column = column};
}

void Calls::run_ret(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('(') && !scanner.take(')')) {
    report(Severity::error, "unread-statement", 0, column, [] {
      return Text{NC_("core", "RET with a jump target is not supported"),
                  NC_("core", "the program continues after the call; return without a target")};
    });
    skip_rest(scanner);
  }
  functions_.ends = true;
}

void Calls::run_call(Scanner& scanner) {
  if (parts_.values.text_follows(scanner)) {
    call_by_text(scanner);
  } else {
    read(scanner);
  }
}

/// Program from outside the control, with or without its folder: EXTCALL("D:/PART.WPD/OP10.SPF").
void Calls::run_extcall(Scanner& scanner) {
  if (parts_.values.text_follows(scanner) || scanner.peek() == '(') {
    call_by_text(scanner);
  } else {
    read(scanner);
  }
}

void Calls::call_by_text(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  set(parts_.values.read_text(scanner), column);
}

void Calls::run_isocall(Scanner& scanner) {
  report(Severity::error, "unread-function", kind_of("ISOCALL"), scanner.column(), [] {
    return Text{NC_("core", "ISOCALL (call of a program in ISO dialect) is not supported"),
                NC_("core", "its motion is skipped")};
  });
  skip_rest(scanner);
}

/// With a name: calls it after every motion from now on; alone: ends that.
void Calls::run_mcall(Scanner& scanner) {
  modal_call_.reset();
  if (!scanner.at_end()) {
    modal_call_ = ModalCall{.call = read_call(scanner), .depth = lines().call_depth()};
  }
}

SubprogramCall Calls::read_call(Scanner& scanner) {
  SubprogramCall call;
  call.column = scanner.column();
  call.name = std::string(scanner.name());
  if (call.name.empty()) {
    throw ReadFault{"syntax", call.column,
                    message(NC_("core", "{} is not a subprogram"), in_quotes(scanner.rest())),
                    NC_("core", "write the name of a subprogram")};
  }
  if (scanner.peek() == '(') {
    call.arguments = read_arguments(scanner);
  }
  return call;
}

Arguments Calls::read_arguments(Scanner& scanner) {
  Arguments arguments;
  require(scanner, '(');
  if (scanner.take(')')) {
    return arguments;
  }
  do {
    const bool missing = scanner.peek() == ',' || scanner.peek() == ')';
    arguments.push_back(missing ? Argument() : read_argument(scanner));
  } while (scanner.take(','));
  require(scanner, ')');
  return arguments;
}

Argument Calls::read_argument(Scanner& scanner) {
  Values& values = parts_.values;
  Argument argument;
  Scanner alone = scanner;
  const std::string_view name = alone.name();
  const bool only_name = !name.empty() && (alone.peek() == ',' || alone.peek() == ')');
  const Variable* const variable = only_name ? values.variables().find(name) : nullptr;
  if (variable != nullptr) {
    argument.variable = upper_case(name);
    argument.array = variable->count() > 1 ? std::optional(*variable) : std::nullopt;
  }
  if (values.text_follows(scanner)) {
    argument.text = values.read_text(scanner);
  } else if (only_name && name.size() == 1 && variable == nullptr) {
    argument.text = upper_case(name);
    scanner = alone;
  } else {
    argument.number = values.read_bounded(scanner);
  }
  return argument;
}

void Calls::run_modal() {
  if (!modal_call_ || modal_call_->depth != lines().call_depth()) {
    return;
  }
  SubprogramCall call = modal_call_->call;
  call.column = words_.first_column("XYZ");
  if (!run_cycle(call)) {
    run_subprogram(call, 1);
  }
}

void Calls::run_block() {
  if (call_ && !run_cycle(*call_)) {
    const double times = words_.has(Address::p) ? std::clamp(words_[Address::p].value, 1.0, 9999.0) : 1;
    run_subprogram(*call_, static_cast<std::uint32_t>(times));
  }
  if (functions_.ends) {
    end_or_return();
  }
}

void Calls::end_or_return() {
  parts_.splines.finish();
  if (!leave()) {
    lines().end_program();
  }
}

bool Calls::run_cycle(const SubprogramCall& call) {
  return parts_.cycles.run(call, modal_call_ ? &modal_call_->call : nullptr);
}

void Calls::run_subprogram(const SubprogramCall& call, std::uint32_t times) {
  parts_.splines.finish();
  const Subprogram subprogram = parts_.subprograms.find(call.name);
  if (subprogram.text != nullptr) {
    enter(call, subprogram, times);
    return;
  }
  const std::string name = plain_name(call.name);
  const bool cycle = is_cycle(name);
  report(Severity::error, cycle ? MessageCode("unread-cycle") : MessageCode("subprogram-missing"),
         kind_of(name), call.column, [&] {
           return cycle
                      ? Text{message(NC_("core", "cycle {} is not supported"), name),
                             NC_("core", "its motion is skipped")}
                      : Text{message(NC_("core",
                                         "subprogram {} is neither in the program nor a file in its folder"),
                                     feedscope::in_quotes(call.name)),
                             NC_("core", "its motion is skipped; add it to the program or to its folder")};
         });
}

void Calls::enter(const SubprogramCall& call, const Subprogram& subprogram, std::uint32_t times) {
  Scope scope;
  scope.parameters.arguments = call.arguments;
  scope.ends_caller = functions_.ends;
  scope.kept = parts_.kept_modes.keep();
  if (!lines().call(subprogram.text, subprogram.line, times)) {
    return;
  }
  functions_.ends = false;
  scopes_.push_back(std::move(scope));
  parts_.values.variables().enter();
}

/// Returns false outside of calls.
bool Calls::leave() {
  const LineRunner::Returned returned = lines().return_from_call();
  if (returned == LineRunner::Returned::left) {
    come_back();
  }
  return returned != LineRunner::Returned::no_call;
}

void Calls::come_back() {
  parts_.splines.finish();
  const Scope scope = std::move(scopes_.back());
  scopes_.pop_back();
  return_values(scope.parameters);
  parts_.repeats.leave_call();
  if (modal_call_ && modal_call_->depth > lines().call_depth()) {
    modal_call_.reset();
  }
  if (scope.parameters.keeps_modes) {
    parts_.kept_modes.restore(scope.kept);
  }
  if (scope.ends_caller) {
    end_or_return();
  }
}

/// VAR parameters: copies the final values of the subprogram's parameters to the caller's variables.
void Calls::return_values(const Parameters& parameters) {
  Variables& variables = parts_.values.variables();
  std::vector<std::pair<std::string, Variable>> returned;
  for (const auto& [own, callers] : parameters.returned) {
    if (const Variable* const value = variables.find(own)) {
      returned.emplace_back(callers, *value);
    }
  }
  variables.leave();
  for (auto& [callers, value] : returned) {
    Variable* const target = variables.find(callers);
    if (target != nullptr && target->is_text() == value.is_text() && target->count() == value.count()) {
      target->numbers = std::move(value.numbers);
      target->texts = std::move(value.texts);
    }
  }
}

}  // namespace feedscope::sinumerik
