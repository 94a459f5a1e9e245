#include "ui/lessons/lesson_desk.h"

#include <QPointer>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "ui/language/in_language.h"
#include "ui/language/texts.h"
#include "ui/lessons/lesson_tries.h"
#include "ui/lessons/tries_table.h"

namespace feedscope::ui {

namespace {

/// Setup of the lesson's machine file with the lesson's changes.
SetupState state_of(const LessonSetup& lesson) {
  return SetupState::between(lesson.file, lesson.setup);
}

QString measured_text(const Measure& measure, const Run& run, const std::string& language) {
  try {
    LessonQuantity quantity{measure, {}, {}, Relation::ratio, measure.spec->decimals};
    return QString::fromStdString(feedscope::value_text(quantity, measured(measure, run), language));
  } catch (const InputError&) {
    return {};  // in this program, nothing moves on the line
  }
}

bool has_value(const std::vector<LessonTry>& tries, const std::string& value) {
  return std::ranges::find(tries, value, &LessonTry::value) != tries.end();
}

}  // namespace

/// Clears the tries at a question. Undo restores them together with tries made since; a value tried again
/// keeps its newer result. Redo clears only what was cleared before.
class LessonDesk::Clearing : public QUndoCommand {
 public:
  Clearing(LessonDesk& desk, Place place)
      : QUndoCommand(tr("clear the values tried")), desk_(&desk), place_(std::move(place)) {}

  void redo() override {
    if (desk_ != nullptr) {
      QuestionWork& work = desk_->work_[place_];
      if (!std::exchange(done_before_, true)) {
        setting_ = work.setting;
        measure_ = work.measure;
        tries_ = std::exchange(work.tries, {});
      } else {
        std::erase_if(work.tries, [this](const LessonTry& one) {
          return has_value(tries_, one.value) && !has_value(since_, one.value);
        });
      }
      emit desk_->work_changed();
    }
  }
  void undo() override {
    if (desk_ == nullptr) {
      return;
    }
    QuestionWork& work = desk_->work_[place_];
    const bool same = work.tries.empty() || (work.setting == setting_ && work.measure == measure_);
    if (same) {
      work.setting = setting_;
      work.measure = measure_;
      since_ = std::exchange(work.tries, tries_);
      for (const LessonTry& one : since_) {
        put_try(one, work.tries);
      }
      emit desk_->work_changed();
    }
  }

 private:
  QPointer<LessonDesk> desk_;  ///< the history outlives it when the window is rebuilt in another language
  Place place_;
  std::string setting_;
  std::string measure_;
  std::vector<LessonTry> tries_;  ///< cleared
  std::vector<LessonTry> since_;  ///< made between clearing and undoing it
  bool done_before_ = false;
};

LessonDesk::LessonDesk(Workbench& workbench, std::string language, QObject* parent)
    : QObject(parent), workbench_(workbench), language_(std::move(language)) {
  connect(&workbench_, &Workbench::run_changed, this, &LessonDesk::follow_run);
}

LessonDesk::Catalogue LessonDesk::read_catalogue(const std::string& language) {
  Catalogue catalogue;
  try {
    for (const std::filesystem::path& file : shipped_lessons()) {
      const Lesson lesson = read_lesson(file, language);
      catalogue.entries.push_back({file, QString::fromStdString(lesson.title),
                                   QString::fromStdString(lesson.learn), lesson.minutes, lesson.half_day});
    }
  } catch (const std::exception& error) {
    catalogue.failure = failure_text(error);
  }
  return catalogue;
}

void LessonDesk::list() {
  if (!entries_.empty() || listing_.busy()) {
    return;
  }
  listing_.start([language = language_](JobControl&) { return read_catalogue(language); },
                 [this](const JobOutcome<Catalogue>& outcome) {
                   const Catalogue catalogue = outcome.result.value_or(Catalogue{{}, outcome.failure});
                   entries_ = catalogue.entries;
                   emit listed();
                   if (!catalogue.failure.isEmpty()) {
                     emit failed(catalogue.failure);
                   }
                 });
}

std::shared_ptr<const LessonDesk::OpenLesson> LessonDesk::read(const std::filesystem::path& file,
                                                               const std::string& language,
                                                               Progress& progress) {
  auto result = std::make_shared<OpenLesson>();
  result->lesson = read_lesson(file, language);
  result->numbers = LessonRuns(result->lesson).numbers(&progress);
  return result;
}

void LessonDesk::open(const std::filesystem::path& file, bool then_set_up) {
  set_up_pending_ = then_set_up;
  emit opening();
  opening_.start(
      [file, language = language_](JobControl& control) { return read(file, language, control.progress); },
      [this](const JobOutcome<std::shared_ptr<const OpenLesson>>& outcome) {
        if (outcome.result) {
          take(*outcome.result);
        } else if (!outcome.cancelled()) {
          emit failed(outcome.failure);
        }
      });
}

void LessonDesk::take(const std::shared_ptr<const OpenLesson>& lesson) {
  open_ = lesson;
  question_ = 0;
  former_ = workbench_.shown();
  find_programs();
  view_pending_ = false;
  emit opened();
  emit question_changed();
  emit cover_changed();
  if (!std::exchange(set_up_pending_, false)) {
    measure();
  } else if (awaits_prediction()) {
    cover_window();
  } else {
    set_up_window();
  }
}

/// Leaves no run of another lesson in view; machine, control and tolerance are those of the text.
void LessonDesk::cover_window() {
  try {
    const LessonSetup start = set_up(open_->lesson, {});
    emit set_up_begins();
    workbench_.close_for_lesson({0, {}, run_colour(0), true, state_of(start)}, start.setup.load);
  } catch (const std::exception& error) {
    report(error);
  }
}

bool LessonDesk::awaits_prediction() const {
  return open_ != nullptr && !open_->lesson.predict.empty() && !unlocked_ &&
         !covers_.revealed.contains(open_->lesson.id) && prediction().isEmpty();
}

QString LessonDesk::written(std::size_t number) const {
  const auto found = open_ == nullptr ? work_.end() : work_.find({open_->lesson.id, number});
  return found == work_.end() ? QString() : found->second.answer;
}

QString LessonDesk::prediction() const {
  return written(ui::prediction);
}

QString LessonDesk::sentence() const {
  return open_ == nullptr ? QString()
                          : filled(open_->lesson.transfer)
                                .trimmed()
                                .replace('\n', ' ')
                                .replace(QChar::Nbsp, ' ');  // as text fields return it
}

QString LessonDesk::transfer() const {
  const QString completed = written(ui::transfer);
  return completed.isEmpty() ? sentence() : completed;
}

void LessonDesk::set_transfer(const QString& text) {
  if (open_ != nullptr && text != transfer()) {
    work_[{open_->lesson.id, ui::transfer}].answer = text == sentence() ? QString() : text;
    emit work_changed();
  }
}

void LessonDesk::predict(const QString& text) {
  if (!awaits_prediction() || text.trimmed().isEmpty()) {
    return;
  }
  work_[{open_->lesson.id, ui::prediction}].answer = text.trimmed();
  covers_.drafts.erase(open_->lesson.id);
  emit work_changed();
  emit cover_changed();
  set_up_window();
}

QString LessonDesk::draft() const {
  const auto found = open_ == nullptr ? covers_.drafts.end() : covers_.drafts.find(open_->lesson.id);
  return found == covers_.drafts.end() ? QString() : found->second;
}

void LessonDesk::set_draft(const QString& text) {
  if (awaits_prediction()) {
    covers_.drafts[open_->lesson.id] = text;
  }
}

void LessonDesk::reveal() {
  if (awaits_prediction()) {
    covers_.revealed.insert(open_->lesson.id);
    emit cover_changed();
    set_up_window();
  }
}

void LessonDesk::unlock(bool on) {
  if (on != unlocked_) {
    unlocked_ = on;
    emit cover_changed();
  }
}

QString LessonDesk::filled(const std::string& text) const {
  return QString::fromStdString(kept_together(feedscope::filled(text, open_->numbers)));
}

QString LessonDesk::watched() const {
  return QString::fromStdString(title_of(open_->lesson.questions[question_].watch, open_->lesson.language));
}

void LessonDesk::set_up_window() {
  if (open_ == nullptr || awaits_prediction()) {
    return;
  }
  try {
    const LessonSetup start = set_up(open_->lesson, {});
    std::vector<RunItem> runs{{0, {}, workbench_.runs().current_item().colour, true, state_of(start)}};
    for (const Changes& changes : open_->lesson.window.runs) {
      runs.push_back({0, {}, run_colour(runs.size()), true, state_of(set_up(open_->lesson, changes))});
    }
    emit set_up_begins();
    view_pending_ = true;
    workbench_.open_for_lesson(start.program, std::move(runs), 0, start.setup.load);
  } catch (const std::exception& error) {
    report(error);
  }
}

void LessonDesk::choose_question(std::size_t number) {
  if (open_ != nullptr && number < open_->lesson.questions.size() && number != question_) {
    question_ = number;
    former_ = workbench_.shown();
    find_programs();
    emit question_changed();
    measure();
  }
}

void LessonDesk::move_control(const std::string& value) {
  if (open_ == nullptr || awaits_prediction()) {
    return;
  }
  const Question& question = open_->lesson.questions[question_];
  Changes changes = question.with;
  changes.push_back(question.control.key + "=" + value);
  try {
    const LessonSetup moved = set_up(open_->lesson, changes);
    RunList& runs = workbench_.runs();
    if (moved.program == workbench_.file()) {
      runs.set_setup(runs.current(), state_of(moved),
                     setting_title(question.control.key) + QLatin1Char(' ') + control_value_text(value));
      workbench_.hold_machine();
    } else {
      std::vector<RunItem> all = runs.items();
      all[runs.current()].setup = state_of(moved);
      workbench_.open_for_lesson(moved.program, std::move(all), runs.current(), moved.setup.load);
    }
  } catch (const std::exception& error) {
    report(error);
  }
}

void LessonDesk::follow_run() {
  if (view_pending_ && workbench_.shown() != nullptr) {
    view_pending_ = false;
    emit view_wanted(open_->lesson.window);
  }
  measure();
}

void LessonDesk::find_programs() {
  programs_.clear();
  const Question& question = open_->lesson.questions[question_];
  const bool of_programs = question.control.key == "program";
  try {
    programs_.insert(set_up(open_->lesson, question.with).program);
    for (const std::string& value : of_programs ? question.control.values : std::vector<std::string>()) {
      Changes changes = question.with;
      changes.push_back(question.control.key + "=" + value);
      programs_.insert(set_up(open_->lesson, changes).program);
    }
  } catch (const std::exception& error) {
    report(error);
  }
}

void LessonDesk::measure() {
  const auto shown = workbench_.shown();
  // With another program open, such as that of another question, its value would appear under this question.
  if (open_ == nullptr || shown == nullptr || !programs_.contains(workbench_.file())) {
    measuring_.cancel();
    if (!value_.isEmpty()) {
      value_.clear();
      emit value_changed();
    }
    return;
  }
  measuring_.start(
      [open = open_, number = question_, shown, former = shown == former_.lock(),
       program = workbench_.file()](JobControl&) {
        const Question& question = open->lesson.questions[number];
        Measured result;
        if (auto value = tried_value(open->lesson, question, program, shown->run)) {
          result.tried = try_of(question, std::move(*value), shown->run);
        }
        if (result.tried || !former) {
          result.text = measured_text(question.watch, shown->run, open->lesson.language);
        }
        return result;
      },
      [this, open = open_, where = place()](const JobOutcome<Measured>& outcome) {
        if (!outcome.result) {
          return;
        }
        value_ = outcome.result->text;
        emit value_changed();
        if (outcome.result->tried) {
          keep_try(open->lesson.questions[where.second], *outcome.result->tried, work_[where]);
          emit work_changed();
        }
      });
}

QuestionWork LessonDesk::work() const {
  if (open_ == nullptr) {
    return {};
  }
  const auto found = work_.find(place());
  if (found == work_.end()) {
    return {};
  }
  QuestionWork work = found->second;
  if (!is_work_on(open_->lesson.questions[question_], work)) {
    work.tries.clear();
  }
  return work;
}

void LessonDesk::set_answer(const QString& answer) {
  if (open_ != nullptr && work().answer != answer) {
    work_[place()].answer = answer;
    emit work_changed();
  }
}

LessonAnswers LessonDesk::answers() const {
  LessonAnswers answers;
  for (const auto& [where, done] : work_) {
    if (!done.answer.trimmed().isEmpty()) {
      answers[where] = done.answer;
    }
  }
  return answers;
}

void LessonDesk::clear_tries() {
  if (open_ != nullptr && !work().tries.empty()) {
    workbench_.runs().history().push(new Clearing(*this, place()));
  }
}

void LessonDesk::set_all_work(LessonWork work) {
  if (work_ != work) {
    work_ = std::move(work);
    emit work_changed();
    emit cover_changed();
  }
}

}  // namespace feedscope::ui
