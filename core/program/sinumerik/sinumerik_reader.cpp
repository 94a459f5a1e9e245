#include "core/program/sinumerik/sinumerik_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

SinumerikReader::SinumerikReader(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                                 Progress* progress)
    : Reader(std::move(source), options, progress),
      values_(path(), [this](std::string_view code, int detail, std::uint32_t column, const Text& said) {
        // ENDFOR reads the line of FOR, whose columns are not its own.
        const bool own = column <= text().line(line()).size();
        report(Severity::warning, code, detail, own ? column : 0, [&] { return said; });
      }) {
  modal_.inch = modal_.inch_feed = first_unit() == LengthUnit::inch;
  take_given_offsets();
}

void SinumerikReader::run_line(std::string_view line) {
  replaced_.reset();
  if (repeat_is_over(this->line())) {
    return;
  }
  if (line.starts_with('%')) {
    run_head(line);
    return;
  }
  if (!macros_.empty()) {
    replaced_ = macros_.replaced(line);
  }
  const Block& block = lexer_.read(replaced_ ? std::string_view(replaced_->text) : line);
  const bool skipped = options().skip_deleted_blocks && block.delete_level > 0;
  if (!skipped && !(block.words.empty() && block.faults.empty() && block.statement == 0)) {
    (scopes_.empty() ? words_met_ : scopes_.back().words_met) = true;
    run_block(block);
  }
  if (this->line() == text().line_count()) {
    repeat_is_over(this->line() + 1);
  }
}

void SinumerikReader::run_head(std::string_view line) {
  const bool words_met = scopes_.empty() ? words_met_ : scopes_.back().words_met;
  const ProgramIndex::Section* const main = call_depth() == 0 ? index().main_section() : nullptr;
  if (words_met) {
    end_or_return();
  } else if (main != nullptr && main->first > this->line() && !line.ends_with("_MPF")) {
    jump_to(main->first);
  }
}

void SinumerikReader::run_out() {
  return_from_call();
}

void SinumerikReader::left_call() {
  finish_spline();
  Scope scope = std::move(scopes_.back());
  scopes_.pop_back();
  std::vector<std::pair<std::string, Variable>> returned;
  for (const auto& [own, outer] : scope.returned) {
    if (const Variable* const value = values_.variables().find(own)) {
      returned.emplace_back(outer, *value);
    }
  }
  values_.variables().leave();
  for (auto& [outer, value] : returned) {
    Variable* const target = values_.variables().find(outer);
    if (target != nullptr && target->is_text() == value.is_text() && target->count() == value.count()) {
      target->numbers = std::move(value.numbers);
      target->texts = std::move(value.texts);
    }
  }
  std::erase_if(repeats_, [&](const Repeat& repeat) { return repeat.depth > call_depth(); });
  if (modal_call_ && modal_call_->depth > call_depth()) {
    modal_call_.reset();
  }
  if (scope.saves) {
    modal_ = scope.modal;
    frames_ = scope.frames;
    path_words_ = scope.path_words;
    applied_ = Applied::none;
    set_frame();
  }
  if (scope.ends_caller) {
    end_or_return();
  }
}

std::uint32_t SinumerikReader::first_word(std::string_view line) {
  if (line.starts_with('%')) {
    return 0;
  }
  const Block& block = lexer_.read(line);
  return block.words.empty() ? block.statement : block.words.front().column;
}

void SinumerikReader::run_block(const Block& block) {
  count_block();
  words_.clear();
  groups_.fill(nullptr);
  own_block_ = nullptr;
  machine_axes_ = false;
  fixed_point_ = 1;
  tool_change_ = false;
  spindle_start_ = false;
  spindle_stop_ = false;
  stop_ = false;
  exact_stop_ = false;
  ends_ = false;
  moved_ = false;
  call_.reset();
  if (has_positions_) {
    positions_.fill(std::nullopt);
    has_positions_ = false;
  }
  bool sound = report_faults(block);
  gather(block);
  if (has_polynomials_) {
    polynomials_.fill(std::nullopt);
    has_polynomials_ = false;
  }
  if (block.statement > 0) {
    try {
      Scanner scanner(without_comment(block.text), block.statement - 1);
      run_statements(scanner);
    } catch (const ReadFault& fault) {
      sound = false;
      report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
    }
  }
  execute_block(sound);
}

bool SinumerikReader::report_faults(const Block& block) {
  for (const Fault& fault : block.faults) {
    const std::string_view written = block.text_of(fault);
    const bool range = fault.kind == FaultKind::number_range;
    report(Severity::error, range ? "number-range" : "malformed-number", 0, fault.column, [&] {
      return Text{range ? fmt::format("{} is beyond the largest number, 1000000000", quoted(written))
                        : fmt::format("{} has no readable number", quoted(written)),
                  "the block does not move; correct the number"};
    });
  }
  return block.faults.empty();
}

void SinumerikReader::gather(const Block& block) {
  for (const Word& word : block.words) {
    switch (word.letter) {
      case 'N':
        break;
      case 'G':
        apply_g(word.value, word.column, block.text_of(word));
        break;
      case 'M':
        apply_m(word.value);
        break;
      case 'P':
        words_.set(Address::p, {.value = word.value, .column = word.column, .reading = Reading::modal});
        break;
      default:
        set_letter(word.letter, {.value = word.value, .column = word.column, .reading = Reading::modal},
                   block.text_of(word));
    }
  }
}

void SinumerikReader::set_letter(char letter, const BlockWords::Value& value, std::string_view written) {
  if (letter == 'L') {
    // L1 and L01 are different subprograms.
    const std::string_view digits =
        written.substr(std::min(written.find_first_not_of(" \t", 1), written.size()));
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
      report(Severity::error, "subprogram-name", letter, value.column, [&] {
        return Text{fmt::format("{} names no subprogram", quoted(written)),
                    "write its number with digits alone, as L12; it is not called"};
      });
      return;
    }
    call_ = SubprogramCall{
        .name = "L" + std::string(digits), .column = value.column, .arguments = {}, .bracketed = false};
    return;
  }
  if (words_.has(letter)) {
    report(Severity::error, "duplicate-word", letter, value.column, [&] {
      return Text{fmt::format("{} stands twice in the block", letter),
                  fmt::format("{} counts; remove the other", quoted(written))};
    });
  }
  words_.set(letter, value);
}

void SinumerikReader::apply_m(double number) {
  ends_ = ends_ || number == 2 || number == 17 || number == 30;
  tool_change_ = tool_change_ || number == 6;
  stop_ = stop_ || number == 0 || number == 1;
  spindle_start_ = spindle_start_ || number == 3 || number == 4;
  spindle_stop_ = spindle_stop_ || number == 5 || number == 19;
}

/// Those that act before the block moves.
void SinumerikReader::run_m_functions() {
  if (!tool_change_ && !spindle_start_ && !spindle_stop_) {
    return;
  }
  finish_spline();
  if (tool_change_) {
    change_tool(modal_.tool);
  }
  if (spindle_stop_) {
    stop_spindle();
  }
  if (spindle_start_) {
    start_spindle();
  }
}

void SinumerikReader::apply_g(double number, std::uint32_t column, std::string_view written) {
  const int g = number >= 0 && number < 1000 && number == std::floor(number) ? static_cast<int>(number) : -1;
  const Function* const function = find_g(g);
  if (function == nullptr) {
    report(Severity::error, "unknown-g", g, column, [&] {
      return Text{fmt::format("{} is not a known G word", quoted(written)),
                  "it is left out; the path may differ from what the control does"};
    });
    return;
  }
  if (function->action == Action::work_offset) {
    change_work_offset(g, column);
  }
  apply(*function, column);
}

void SinumerikReader::execute_block(bool sound) {
  apply_feed();
  apply_modal_corners();
  if (own_block_ == nullptr) {
    apply_compensation();
  }
  run_m_functions();
  if (sound) {
    if (own_block_ != nullptr) {
      finish_spline();
      apply_frame();
    } else {
      move();
      move_positioning_axes();
    }
    if (moved_ && modal_call_ && modal_call_->depth == call_depth()) {
      SubprogramCall call = modal_call_->call;
      call.column = words_.first_column("XYZ");
      if (!run_cycle(call)) {
        run_subprogram(call, 1);
      }
    }
  }
  finish_block();
}

void SinumerikReader::finish_block() {
  if (stop_) {
    finish_spline();
    stop_program();
  }
  if (call_) {
    const auto times = static_cast<std::uint32_t>(
        words_.has(Address::p) ? std::clamp(words_[Address::p].value, 1.0, 9999.0) : 1.0);
    if (!run_cycle(*call_)) {
      run_subprogram(*call_, times);
    }
  }
  if (ends_) {
    end_or_return();
  }
}

void SinumerikReader::end_or_return() {
  finish_spline();
  if (!return_from_call()) {
    end_program();
  }
}

}  // namespace feedscope
