#include "ui/models/lesson_desk.h"

#include <QLocale>
#include <QtConcurrentRun>
#include <utility>

#include "core/base/error.h"

namespace feedscope::ui {

namespace {

/// The machine's file with what the lesson changes.
SetupState state_of(const LessonSetup& lesson) {
  return SetupState::between(lesson.file, lesson.setup);
}

QString measured_text(const Measure& measure, const Run& run) {
  try {
    const QString number = QLocale().toString(measured(measure, run), 'f', measure.spec->decimals);
    return measure.spec->unit.empty()
               ? number
               : QStringLiteral("%1 %2").arg(number, QString::fromStdString(measure.spec->unit));
  } catch (const InputError&) {
    return {};  // nothing moves on the line in this program
  }
}

}  // namespace

LessonDesk::LessonDesk(Workbench& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&listing_, &QFutureWatcher<Catalogue>::finished, this, [this] {
    Catalogue catalogue = listing_.result();
    entries_ = std::move(catalogue.entries);
    emit listed();
    if (!catalogue.failure.isEmpty()) {
      emit failed(catalogue.failure);
    }
  });
  connect(&opening_, &QFutureWatcher<std::shared_ptr<const OpenLesson>>::finished, this,
          &LessonDesk::take_lesson);
  connect(&measuring_, &QFutureWatcher<QString>::finished, this, [this] {
    if (measuring_.future().resultCount() > 0) {  // none: there was nothing to measure
      value_ = measuring_.result();
      emit value_changed();
    }
  });
  connect(&model_, &Workbench::run_changed, this, &LessonDesk::follow_run);
}

LessonDesk::~LessonDesk() {
  if (progress_ != nullptr) {
    progress_->cancel();
  }
  listing_.waitForFinished();
  opening_.waitForFinished();
  measuring_.waitForFinished();
}

LessonDesk::Catalogue LessonDesk::read_catalogue() {
  Catalogue catalogue;
  try {
    for (const std::filesystem::path& file : shipped_lessons()) {
      const Lesson lesson = read_lesson(file);
      catalogue.entries.push_back(
          {file, QString::fromStdString(lesson.title), QString::fromStdString(lesson.learn), lesson.minutes});
    }
  } catch (const std::exception& error) {
    catalogue.failure = QString::fromUtf8(error.what());
  }
  return catalogue;
}

void LessonDesk::list() {
  if (entries_.empty() && !listing_.isRunning()) {
    listing_.setFuture(QtConcurrent::run(&LessonDesk::read_catalogue));
  }
}

std::shared_ptr<const LessonDesk::OpenLesson> LessonDesk::read(const std::filesystem::path& file,
                                                               Progress& progress) {
  auto result = std::make_shared<OpenLesson>();
  try {
    result->lesson = read_lesson(file);
    result->numbers = LessonRuns(result->lesson).numbers(&progress);
  } catch (const Cancelled&) {
    return nullptr;
  } catch (const std::exception& error) {
    result->failure = QString::fromUtf8(error.what());
  }
  return result;
}

void LessonDesk::open(const std::filesystem::path& file, bool then_set_up) {
  set_up_pending_ = then_set_up;
  if (progress_ != nullptr) {
    progress_->cancel();
  }
  progress_ = std::make_shared<Progress>();
  opening_.setFuture(QtConcurrent::run([file, progress = progress_] { return read(file, *progress); }));
}

void LessonDesk::take_lesson() {
  const std::shared_ptr<const OpenLesson> taken = opening_.result();
  if (taken == nullptr) {
    return;
  }
  if (!taken->failure.isEmpty()) {
    emit failed(taken->failure);
    return;
  }
  open_ = taken;
  program_.clear();
  try {
    program_ = set_up(open_->lesson, {}).program;
  } catch (const std::exception& error) {
    report(error);
  }
  question_ = 0;
  view_pending_ = false;
  emit opened();
  emit question_changed();
  if (std::exchange(set_up_pending_, false)) {
    set_up_window();
  } else {
    measure();
  }
}

QString LessonDesk::filled(const std::string& text) const {
  return QString::fromStdString(feedscope::filled(text, open_->numbers));
}

void LessonDesk::set_up_window() {
  if (open_ == nullptr) {
    return;
  }
  try {
    const LessonSetup start = set_up(open_->lesson, {});
    std::vector<RunItem> runs{{0, {}, model_.runs().current_item().colour, true, state_of(start)}};
    for (const Changes& changes : open_->lesson.window.runs) {
      runs.push_back({0, {}, run_colour(runs.size()), true, state_of(set_up(open_->lesson, changes))});
    }
    view_pending_ = true;
    program_ = start.program;
    model_.open(start.program, std::move(runs), 0);
  } catch (const std::exception& error) {
    report(error);
  }
}

void LessonDesk::choose_question(std::size_t number) {
  if (open_ != nullptr && number < open_->lesson.questions.size() && number != question_) {
    question_ = number;
    emit question_changed();
    measure();
  }
}

void LessonDesk::move_control(const std::string& value) {
  if (open_ == nullptr) {
    return;
  }
  const Question& question = open_->lesson.questions[question_];
  Changes changes = question.with;
  changes.push_back(question.control.key + "=" + value);
  try {
    const LessonSetup moved = set_up(open_->lesson, changes);
    program_ = moved.program;
    RunList& runs = model_.runs();
    if (moved.program == model_.file()) {
      runs.set_setup(runs.current(), state_of(moved), QString::fromStdString(changes.back()));
      model_.hold_machine();
    } else {
      std::vector<RunItem> all = runs.items();
      all[runs.current()].setup = state_of(moved);
      model_.open(moved.program, std::move(all), runs.current());
    }
  } catch (const std::exception& error) {
    report(error);
  }
}

void LessonDesk::follow_run() {
  if (view_pending_ && model_.shown() != nullptr) {
    view_pending_ = false;
    emit view_wanted(open_->lesson.window);
  }
  measure();
}

void LessonDesk::measure() {
  const auto shown = model_.shown();
  // Another program than the lesson's may be open: its number would stand under the lesson's question.
  if (open_ == nullptr || shown == nullptr || model_.file() != program_) {
    measuring_.setFuture({});
    if (!value_.isEmpty()) {
      value_.clear();
      emit value_changed();
    }
    return;
  }
  const Measure watch = open_->lesson.questions[question_].watch;
  measuring_.setFuture(QtConcurrent::run([watch, shown] { return measured_text(watch, shown->run); }));
}

}  // namespace feedscope::ui
