#include "app/window_start.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/lessons/lesson.h"
#include "ui/lessons/lesson_view.h"
#include "ui/trace/trace_view.h"

namespace feedscope {
namespace {

bool is_given(const GivenOption& option) {
  return option.second;
}

void refuse(const std::vector<GivenOption>& options, const std::string& reason) {
  if (const auto given = std::ranges::find_if(options, is_given); given != options.end()) {
    throw InputError(fmt::format("{} {}", given->first, reason));
  }
}

void check(const RunOptions& options, const std::string& lesson) {
  const std::vector<GivenOption> of_run = given_of_run(options);
  const std::vector<GivenOption> of_program = given_of(options);
  if (!lesson.empty()) {
    const std::string reason =
        fmt::format("cannot be combined with lesson '{}', which has its own; give one of them", lesson);
    refuse(of_run, reason);
    refuse(of_program, reason);
  }
  if (ui::is_session_file(options.file)) {
    const std::string reason = fmt::format(
        "cannot be combined with session '{}', which has its own; give the NC program instead, or open the "
        "session and change it there",
        options.file);
    refuse(of_run, reason);
    refuse(of_program, reason);
  }
  if (options.file.empty()) {
    refuse(of_program, "is an option of the program, which is missing; give the NC program too");
  }
}

void check(const RunOptions& options, const std::vector<std::string>& traces) {
  if (!traces.empty() && options.file.empty()) {
    throw InputError("--trace needs the program that was recorded; give the NC program too");
  }
  for (const std::string& trace : traces) {
    if (!ui::TraceView::is_trace(trace)) {
      throw InputError(fmt::format(
          "--trace '{}' holds no trace that can be read: no rows of samples; see: feedscope trace --help",
          trace));
    }
  }
}

ui::SetupState setup_of(const RunOptions& options, bool run_asked) {
  if (!run_asked) {
    return ui::SetupState(make_setup({}));
  }
  const Dialect dialect =
      options.file.empty() ? Dialect::iso
                           : dialect_of(options, SourceText::from_file(std::filesystem::path(options.file)));
  const SetupRequest request = options.request(dialect);
  return ui::SetupState::between(make_setup({request.machine, request.model, {}, {}, dialect}),
                                 make_setup(request));
}

}  // namespace

WindowStart::WindowStart(const RunOptions& options, const std::string& lesson,
                         std::vector<std::string> traces, bool unlocked)
    : file_((check(options, lesson), check(options, traces), options.file)),
      lesson_(lesson.empty() ? std::filesystem::path() : find_lesson(lesson)),
      traces_(std::move(traces)),
      reading_(options.reading()),
      unlocked_(unlocked),
      run_asked_(std::ranges::any_of(given_of_run(options), is_given)),
      setup_(setup_of(options, run_asked_)) {}

void WindowStart::show(ui::MainWindow& window, ui::Workbench& model) const {
  if (run_asked_) {
    model.runs().replace({{0, {}, ui::run_colour(0), true, setup_}}, 0);
    model.hold_machine();
  }
  if (!file_.empty()) {
    window.open(file_);
    model.set_reading(reading_);
    for (const std::string& trace : traces_) {
      window.part<ui::TraceView>().open(trace);
    }
    window.session().begin_here();
  } else if (!lesson_.empty()) {
    window.part<ui::LessonView>().desk().unlock(unlocked_);
    window.open_lesson(lesson_);
  } else if (!run_asked_) {
    window.session().offer_left_behind();
  }
}

}  // namespace feedscope
