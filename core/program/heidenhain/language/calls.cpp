#include "core/program/heidenhain/language/calls.h"

#include <utility>

#include "core/program/text/message.h"

namespace feedscope::heidenhain {

bool Calls::enter(const std::shared_ptr<const SourceText>& called, std::uint32_t line, bool program) {
  if (!(called != nullptr ? lines().call(called, line) : lines().call(line))) {
    return false;
  }
  Frame& frame = frames_.emplace_back();
  frame.program = program;
  frame.unit = modal_.unit;
  if (program) {
    frame.locals = parameters().exchange_locals({});
  }
  return true;
}

/// Calls of labels and programs run once each.
void Calls::leave() {
  lines().return_from_call();
  Frame& frame = frames_.back();
  if (frame.program) {
    modal_.unit = frame.unit;
    parameters().exchange_locals(std::move(frame.locals));
  }
  frames_.pop_back();
}

void Calls::call_label(const std::string& label, std::uint32_t column) {
  if (const auto line = labels_.line_of(label, column)) {
    enter(nullptr, *line, false);
  }
}

void Calls::repeat_from_label(const std::string& label, double times, std::uint32_t column) {
  const auto line = labels_.line_of(label, column);
  if (!line) {
    return;
  }
  const auto [left, is_new] =
      repeats_left_.try_emplace({lines().call_depth(), &lines().text(), lines().line()}, times);
  if (left->second >= 1) {
    --left->second;
    lines().jump_to(*line);
  } else {
    repeats_left_.erase(left);
  }
}

void Calls::jump_to_label(const std::string& label, std::uint32_t column) {
  if (const auto line = labels_.line_of(label, column)) {
    lines().jump_to(*line);
  }
}

void Calls::end_subprogram() {
  if (!frames_.empty() && !frames_.back().program) {
    leave();
  }
}

void Calls::end_of_program() {
  while (!frames_.empty()) {
    const bool program = frames_.back().program;
    leave();
    if (program) {
      return;
    }
  }
  lines().end_program();
}

void Calls::call_program(std::string_view written, std::uint32_t column) {
  Scanner scanner(written);
  const auto parameter = take_parameter(scanner);
  std::string_view name =
      parameter && parameter->kind == QName::Kind::text ? parameters().text(parameter->number) : written;
  while (!name.empty() && (letters::is_blank(name.front()) || name.front() == '"')) {
    name.remove_prefix(1);
  }
  while (!name.empty() && (letters::is_blank(name.back()) || name.back() == '"')) {
    name.remove_suffix(1);
  }
  if (const std::size_t folder = name.find_last_of("\\/:"); folder != std::string_view::npos) {
    name.remove_prefix(folder + 1);
  }
  const std::string file(name);
  const auto called = name.empty() ? nullptr : files_.find({file, file + ".h", file + ".i"});
  if (called == nullptr) {
    report(Severity::error, "subprogram", 0, column, [&] {
      return Text{message(NC_("core", "program {} was not found in the same folder"), in_quotes(name)),
                  NC_("core", "its motion is skipped; copy the file into this folder")};
    });
    return;
  }
  const Dialect found = recognise(*called);
  if (found != Dialect::iso && found != context_.dialect) {
    report(Severity::error, "subprogram", 1, column, [&] {
      return Text{
          message(NC_("core", "program {} is in another dialect, {}"), in_quotes(name), info_of(found).title),
          NC_("core", "its motion is skipped")};
    });
    return;
  }
  enter(called, 1, true);
}

void Calls::stop_all() {
  contour_.flush();
  lines().end_program();
}

}  // namespace feedscope::heidenhain
