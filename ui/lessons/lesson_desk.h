#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "core/lessons/lesson_runs.h"
#include "ui/language/in_language.h"
#include "ui/lessons/lesson_work.h"
#include "ui/shared/job.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

/// A lesson as it stands in a list.
struct LessonEntry {
  std::filesystem::path file;
  QString title;
  QString learn;  ///< what one learns
  double minutes = 0;
  bool half_day = false;  ///< of the course of half a day; all are of that of two days
};

/// The lesson that is worked on in the window: its texts with the numbers measured, the question one is at,
/// and what the current run measures of it. Reading, simulating and measuring run on other threads.
class LessonDesk : public QObject {
  Q_OBJECT

 public:
  /// `workbench` outlives this; `language`: one of lesson_languages().
  explicit LessonDesk(Workbench& workbench, std::string language = "en", QObject* parent = nullptr);

  /// Reads the shipped lessons; listed() follows, failed() for a file that is faulty. Once is enough.
  void list();
  const std::vector<LessonEntry>& entries() const { return entries_; }
  /// Reads a lesson and measures its numbers; opened() or failed() follows. `then_set_up`: the window, as
  /// set_up_window() does.
  void open(const std::filesystem::path& file, bool then_set_up = false);
  bool busy() const { return opening_.busy() || listing_.busy(); }

  /// Null until one is open.
  const Lesson* lesson() const { return open_ == nullptr ? nullptr : &open_->lesson; }
  /// A text of the open lesson with its numbers, Markdown.
  QString filled(const std::string& text) const;

  /// Whether the run of the lesson stays covered: there is something to predict, which nobody has written
  /// yet.
  bool awaits_prediction() const;
  /// Of the open lesson; empty: none.
  QString prediction() const;
  /// Writes it down, once, and sets up the window.
  void predict(const QString& text);
  /// The same without a prediction, until another lesson is opened.
  void reveal();
  /// Whether lessons show their run without a prediction: the choice of a teacher.
  bool unlocked() const { return unlocked_; }
  void unlock(bool on);
  /// Program, runs and settings that the lesson begins with, instead of those in the window; view_wanted()
  /// follows with the first result. Not while it awaits_prediction().
  void set_up_window();
  /// The window is to show something else again: view_wanted() does not follow any more.
  void leave_window() { view_pending_ = false; }
  std::size_t question() const { return question_; }
  void choose_question(std::size_t number);
  /// Gives the control of the question a value in the current run; all else is as the lesson begins, and can
  /// be undone. Not while the lesson awaits_prediction().
  void move_control(const std::string& value);

  /// What was done at the question that is shown: every value that its control was given in the current run,
  /// and the answer. Nothing of it is lost when something else is shown.
  QuestionWork work() const;
  void set_answer(const QString& answer);
  /// To all questions of all lessons.
  LessonAnswers answers() const;
  /// Forgets the values tried at the question that is shown; a step of the history of the workbench.
  void clear_tries();
  /// The same of all lessons, as a session keeps it.
  const LessonWork& all_work() const { return work_; }
  void set_all_work(LessonWork work);

  /// What the question watches, in the language of the lesson.
  QString watched() const;
  /// What the current run measures of it, with its unit, written as the numbers of the lesson; "" while there
  /// is nothing to measure.
  const QString& value() const { return value_; }

 signals:
  void listed();
  void opened();
  /// What the window shows now is about to be replaced by what the lesson begins with.
  void set_up_begins();
  /// awaits_prediction() or unlocked() may be another one.
  void cover_changed();
  void question_changed();
  void value_changed();
  /// Values tried or answers at the question that is shown.
  void work_changed();
  /// How the window is to show the lesson.
  void view_wanted(const feedscope::LessonWindow& view);
  void failed(const QString& message);

 private:
  class Clearing;
  using Place = LessonWork::key_type;
  struct Catalogue {
    std::vector<LessonEntry> entries;
    QString failure;
  };
  struct OpenLesson {
    Lesson lesson;
    WrittenNumbers numbers;
  };
  struct Measured {
    QString text;
    std::optional<LessonTry> tried;
  };

  static Catalogue read_catalogue(const std::string& language);
  static std::shared_ptr<const OpenLesson> read(const std::filesystem::path& file,
                                                const std::string& language, Progress& progress);
  void take(const std::shared_ptr<const OpenLesson>& lesson);
  void measure();
  Place place() const { return {open_->lesson.id, question_}; }
  void follow_run();
  void report(const std::exception& error) { emit failed(failure_text(error)); }

  Workbench& workbench_;
  std::string language_;
  std::vector<LessonEntry> entries_;
  std::shared_ptr<const OpenLesson> open_;
  std::filesystem::path program_;  ///< that the numbers of the open lesson are of
  std::size_t question_ = 0;
  QString value_;
  bool view_pending_ = false;
  bool set_up_pending_ = false;
  bool unlocked_ = false;
  bool revealed_ = false;  ///< the open lesson, without a prediction
  Job<Catalogue> listing_;
  Job<std::shared_ptr<const OpenLesson>> opening_;
  LessonWork work_;
  Job<Measured> measuring_;
};

}  // namespace feedscope::ui
