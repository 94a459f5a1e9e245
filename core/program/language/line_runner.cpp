#include "core/program/language/line_runner.h"

#include <algorithm>
#include <utility>

namespace feedscope {

LineRunner::LineRunner(std::shared_ptr<const SourceText> program, const ReadOptions& options,
                       DiagnosticLog& log)
    : options_(options), log_(log), program_(std::move(program)), text_(program_) {}

bool LineRunner::advance() {
  if (next_line_ > text_->line_count()) {
    return false;
  }
  line_ = next_line_++;
  ++lines_run_;
  last_run_ = std::max(last_run_, shown_line());
  return true;
}

bool LineRunner::call(std::shared_ptr<const SourceText> text, std::uint32_t line, std::uint32_t times) {
  if (calls_.size() >= options_.call_depth) {
    log_.add(Severity::error, "call-depth", 0, place(0), [&] {
      return DiagnosticLog::Text{
          message(NC_("core", "calls are nested more than {} deep"), options_.call_depth),
          NC_("core",
              "this call is skipped; check whether the subprogram calls itself, or raise the limit with "
              "--call-depth")};
    });
    return false;
  }
  ++call_count_;
  calls_.push_back({text_, line_, line, std::max(times, 1U)});
  text_ = std::move(text);
  next_line_ = line;
  return true;
}

LineRunner::Returned LineRunner::return_from_call() {
  if (calls_.empty()) {
    return Returned::no_call;
  }
  Call& last = calls_.back();
  if (--last.times > 0) {
    next_line_ = last.start;
    return Returned::again;
  }
  text_ = std::move(last.text);
  next_line_ = last.line + 1;
  calls_.pop_back();
  return Returned::left;
}

std::uint32_t LineRunner::shown_line() const {
  if (text_ == program_) {
    return line_;
  }
  const auto from_program = std::find_if(calls_.rbegin(), calls_.rend(),
                                         [this](const Call& call) { return call.text == program_; });
  return from_program->line;
}

DiagnosticLog::Place LineRunner::place(std::uint32_t column) const {
  return {line_, column, in_main_text() ? std::string_view() : std::string_view(text_->name())};
}

}  // namespace feedscope
