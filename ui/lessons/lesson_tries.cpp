#include "ui/lessons/lesson_tries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/typed_number.h"
#include "core/machine/contour_tolerance.h"
#include "ui/workbench/setup_state.h"

namespace feedscope::ui {

namespace {

bool is_choice_of_run(const std::string& key) {
  return key == "program" || key == "machine" || key == "model";
}

std::string text_of(const SettingValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
}

/// The suggested value of the lesson that equals `value`, in the lesson's notation; else `value`.
std::string as_suggested(const Control& control, const std::string& value) {
  const auto number = typed_number(value).value;
  const auto found = std::ranges::find_if(control.values, [&](const std::string& one) {
    const auto other = typed_number(one).value;
    return number && other ? *number == *other : one == value;
  });
  return found == control.values.end() ? value : *found;
}

bool is_run_of(const LessonSetup& wanted, const std::filesystem::path& program, const Run& run) {
  return wanted.program == program && wanted.setup.model == run.setup.model &&
         wanted.file.machine.id == run.setup.machine.id &&
         SetupState::between(wanted.file, run.setup).edits() ==
             SetupState::between(wanted.file, wanted.setup).edits();
}

std::vector<std::string> possible_values(const Control& control, const Run& run) {
  if (is_choice_of_run(control.key)) {
    return control.values;
  }
  const std::string key = control.key == "tolerance" ? contour_tolerance_key : control.key;
  return {as_suggested(control, text_of(SetupState(run.setup).value(key)))};
}

std::string csv_number(const std::optional<double>& number) {
  return number ? fmt::format("{:.10g}", *number) : std::string();
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return quoted + '"';
}

}  // namespace

std::optional<std::string> tried_value(const Lesson& lesson, const Question& question,
                                       const std::filesystem::path& program, const Run& run) {
  try {
    for (const std::string& value : possible_values(question.control, run)) {
      Changes changes = question.with;
      changes.push_back(question.control.key + "=" + value);
      if (is_run_of(set_up(lesson, changes), program, run)) {
        return value;
      }
    }
  } catch (const InputError&) {
    // another model without this setting
  }
  return std::nullopt;
}

LessonTry try_of(const Question& question, std::string value, const Run& run) {
  LessonTry one{std::move(value), run.summary.cycle_time, std::nullopt};
  try {
    one.measured = measured(question.watch, run);
  } catch (const InputError&) {
    // in this program, nothing moves on the line
  }
  return one;
}

std::string watched_name(const Measure& watch) {
  std::string name = watch.spec->key;
  if (watch.axis != 0) {
    name += fmt::format("_{}", watch.axis);
  }
  if (!watch.cause.empty()) {
    name += '_' + watch.cause;
  }
  if (watch.first_line > 0) {
    name += watch.first_line == watch.last_line
                ? fmt::format("_line_{}", watch.first_line)
                : fmt::format("_lines_{}_{}", watch.first_line, watch.last_line);
  }
  return name;
}

bool is_work_on(const Question& question, const QuestionWork& work) {
  return work.setting == question.control.key && work.measure == watched_name(question.watch);
}

void put_try(LessonTry one, std::vector<LessonTry>& tries) {
  const auto same = std::ranges::find(tries, one.value, &LessonTry::value);
  if (same == tries.end()) {
    tries.push_back(std::move(one));
  } else {
    *same = std::move(one);
  }
}

void keep_try(const Question& question, LessonTry one, QuestionWork& work) {
  if (!is_work_on(question, work)) {
    work.setting = question.control.key;
    work.measure = watched_name(question.watch);
    work.tries.clear();
  }
  put_try(std::move(one), work.tries);
}

std::optional<double> change_percent(double value, double first) {
  constexpr double percent = 100;
  return first == 0 ? std::nullopt : std::optional((value - first) / std::abs(first) * percent);
}

std::string tries_csv(const QuestionWork& work) {
  const bool of_time = work.measure == cycle_time_name;
  std::string csv = csv_text(work.setting) + ",cycle_time_s,change_percent";
  csv += of_time ? std::string("\n") : fmt::format(",{},{}_change_percent\n", work.measure, work.measure);
  for (const LessonTry& one : work.tries) {
    const LessonTry& first = work.tries.front();
    csv += fmt::format("{},{},{}", csv_text(one.value), csv_number(one.cycle_time),
                       csv_number(change_percent(one.cycle_time, first.cycle_time)));
    if (!of_time) {
      const std::optional<double> change =
          one.measured && first.measured ? change_percent(*one.measured, *first.measured) : std::nullopt;
      csv += ',' + csv_number(one.measured) + ',' + csv_number(change);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace feedscope::ui
