#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "core/lessons/lesson_runs.h"
#include "ui/language/in_language.h"
#include "ui/lessons/lesson_work.h"
#include "ui/shared/job.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

/// A lesson in a list.
struct LessonEntry {
  std::filesystem::path file;
  QString title;
  QString learn;  ///< learning objective
  double minutes = 0;
  bool half_day = false;  ///< in the course of half a day; all lessons are in that of two days
};

/// State of the predictions that are not stored yet, by ids of lessons; not kept in a session.
struct LessonCovers {
  std::map<std::string, QString> drafts;  ///< predictions that are typed but not stored
  std::set<std::string> revealed;         ///< lessons whose runs are shown without a prediction
};

/// The open lesson: its texts with the measured numbers, the current question, and its measurement on the
/// current run. Reading, simulating and measuring run on other threads.
class LessonDesk : public QObject {
  Q_OBJECT

 public:
  /// `workbench` outlives this; `language`: one of lesson_languages().
  explicit LessonDesk(Workbench& workbench, std::string language = "en", QObject* parent = nullptr);

  /// Reads the shipped lessons; listed() follows, or failed() for a faulty file. Needed only once.
  void list();
  const std::vector<LessonEntry>& entries() const { return entries_; }
  /// Reads a lesson and measures its numbers; opened() or failed() follows. `then_set_up`: also calls
  /// set_up_window().
  void open(const std::filesystem::path& file, bool then_set_up = false);
  bool busy() const { return opening_.busy() || listing_.busy(); }

  /// Null before one is open.
  const Lesson* lesson() const { return open_ == nullptr ? nullptr : &open_->lesson; }
  /// A text of the open lesson with its numbers, Markdown.
  QString filled(const std::string& text) const;

  /// Whether the run of the lesson is covered, because its prediction is not written yet.
  bool awaits_prediction() const;
  /// For the open lesson; empty: none.
  QString prediction() const;
  /// Stores the prediction, once, and sets up the window.
  void predict(const QString& text);
  /// Typed text of a prediction that is not stored, kept for when the lesson is opened again.
  QString draft() const;
  void set_draft(const QString& text);
  /// The completed sentence about the learner's own control; as the lesson has it while nothing is completed.
  QString transfer() const;
  void set_transfer(const QString& text);
  /// Uncovers the run without a prediction.
  void reveal();
  /// Whether lessons show their run without a prediction; set by a teacher.
  bool unlocked() const { return unlocked_; }
  void unlock(bool on);
  /// For another window on the same workbench.
  const LessonCovers& covers() const { return covers_; }
  void set_covers(LessonCovers covers) { covers_ = std::move(covers); }
  /// Program, runs and settings that the lesson begins with, instead of those in the window; view_wanted()
  /// follows with the first result. Not while it awaits_prediction().
  void set_up_window();
  /// Cancels view_wanted(), because the window will show something else.
  void leave_window() { view_pending_ = false; }
  std::size_t question() const { return question_; }
  void choose_question(std::size_t number);
  /// Sets the question's control to a value in the current run, and everything else as at the start of the
  /// lesson; can be undone. Not while the lesson awaits_prediction().
  void move_control(const std::string& value);

  /// Work on the current question: all values of its control that were tried in the current run, and the
  /// answer. Kept when another question is shown.
  QuestionWork work() const;
  void set_answer(const QString& answer);
  /// Answers to all questions of all lessons.
  LessonAnswers answers() const;
  /// Clears the tried values of the current question, as a step in the history of the workbench.
  void clear_tries();
  /// Work on all lessons, for sessions.
  const LessonWork& all_work() const { return work_; }
  void set_all_work(LessonWork work);

  /// Quantity that the question watches, in the language of the lesson.
  QString watched() const;
  /// Its value in the current run, with unit, formatted like the lesson's numbers; "" if it cannot be
  /// measured, or the run is that of the former question.
  const QString& value() const { return value_; }

 signals:
  void listed();
  /// A lesson is read and its numbers are measured; opened() or failed() follows.
  void opening();
  void opened();
  /// The contents of the window are about to be replaced by the lesson's.
  void set_up_begins();
  /// awaits_prediction() or unlocked() may have changed.
  void cover_changed();
  void question_changed();
  void value_changed();
  /// Tries or answers of the current question have changed.
  void work_changed();
  /// View of the window for the lesson.
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
  void cover_window();
  void find_programs();
  void measure();
  Place place() const { return {open_->lesson.id, question_}; }
  /// The text stored at a number of LessonWork for the open lesson; "": none.
  QString written(std::size_t number) const;
  /// The lesson's sentence about one's own control in one line.
  QString sentence() const;
  void follow_run();
  void report(const std::exception& error) { emit failed(failure_text(error)); }

  Workbench& workbench_;
  std::string language_;
  std::vector<LessonEntry> entries_;
  std::shared_ptr<const OpenLesson> open_;
  std::set<std::filesystem::path> programs_;  ///< in which the current question can be measured
  std::size_t question_ = 0;
  /// Shown when the question was chosen: its value is that of another question, unless this one asks for it.
  std::weak_ptr<const ShownRun> former_;
  QString value_;
  bool view_pending_ = false;
  bool set_up_pending_ = false;
  bool unlocked_ = false;
  LessonCovers covers_;
  Job<Catalogue> listing_;
  Job<std::shared_ptr<const OpenLesson>> opening_;
  LessonWork work_;
  Job<Measured> measuring_;
};

}  // namespace feedscope::ui
