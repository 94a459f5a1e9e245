#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "ui/lessons/lesson_desk.h"
#include "ui/session/autosave.h"
#include "ui/session/session_file.h"

namespace feedscope::ui {

class MainWindow;
class Workbench;

/// What the window shows, as a session file: opened, saved, kept every minute in case the process ends
/// without having been asked to.
class WindowSession : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this. Nothing is kept before begin_keeping().
  WindowSession(MainWindow& window, Workbench& workbench);
  ~WindowSession() override;

  /// Everything as it is now.
  Session capture() const;
  /// Shows a session; what belongs to a simulated run follows when the run is there.
  void show(const Session& session);

  /// Reads and shows a session file. Asks for a program that is not where the session says, whether to go on
  /// with one that has changed since, and whether to keep what has been done in lessons that the session does
  /// not hold. What cannot be used goes to failed().
  /// Returns whether the session is shown.
  bool open(const std::filesystem::path& file);
  /// A program opened by itself: there is no session file any more.
  void forget_file();
  /// Asks for a name if there is none yet, or if `as_new`; asks too if the file has changed since this window
  /// read or wrote it. False if nothing was written.
  bool save(bool as_new = false);
  /// True if runs, annotations, what was identified or answers to lessons differ from what was saved, or from
  /// the program as it was opened.
  bool changed() const;
  /// What the window holds now is how a lesson or a command line begins: nothing of the user's.
  void begin_here() { start_ = essence(); }
  /// Sets aside what the window shows, to be brought back when a lesson has replaced it. Without a program,
  /// or where something is set aside already, nothing happens.
  void set_aside();
  /// Shows what was set aside, with its session file; the layout stays. Nothing, if there is none.
  void bring_back();
  /// Asks whether to save what has changed, of what was set aside too. False: the user does not want to go
  /// on.
  bool may_go();
  const std::filesystem::path& file() const { return file_; }

  struct Aside;
  /// What another window on the same workbench needs to go on with.
  struct Kept {
    Session view;  ///< cursor, panels and layout
    std::filesystem::path file;
    QByteArray saved;
    QByteArray start;
    QByteArray on_disk;
    LessonAnswers answers;  ///< that are saved
    LessonCovers covers;
    std::shared_ptr<const Aside> aside;  ///< null: nothing
  };
  Kept hand_over() const;
  void take_over(const Kept& kept);

  /// From now on, and again after each `pause`. A folder that cannot be written is reported once.
  void begin_keeping(std::chrono::milliseconds pause = std::chrono::minutes(1));
  /// What a process that ended unexpectedly has left, if the user wants it back.
  void offer_left_behind();

 signals:
  void file_changed();
  /// Whether something is set aside now.
  void aside_changed(bool there);
  /// For the user: what of the session could not be used, or what became of it.
  void noticed(const QString& message);
  void failed(const QString& message);

 private:
  /// How everything is shown, without what is shown.
  Session view() const;
  void show_layout(const Session& session);
  void apply_to_run();
  void show_contents(const Session& session);
  void drop_aside();
  Session aside_with_work() const;
  bool contents_changed() const;
  bool save_aside();
  IdentificationState identification() const;
  LessonDesk& desk() const;
  void keep();
  void forget_restored();
  bool find_program(const std::filesystem::path& file, Session& session);
  bool accept_changed_program(const Session& session);
  /// What has been done in lessons of which the session holds nothing, if the user wants to keep it.
  LessonWork lessons_to_keep(const Session& session) const;
  QByteArray essence() const;
  const QByteArray& program_hash() const;
  /// `kept`: as lessons_to_keep().
  void show_file(const std::filesystem::path& file, ReadSession read, const LessonWork& kept,
                 const QByteArray& on_disk);
  /// What is shown is what the file holds, whose hash is `on_disk`.
  void now_in(const std::filesystem::path& file, const QByteArray& on_disk);
  /// Proposes that of a program or session file. Empty if the user gives none.
  std::filesystem::path ask_for_name(const std::filesystem::path& of);
  /// The file to save to: this one, or what the user says if someone else has written to it. Empty: none.
  std::filesystem::path file_after_conflict();

  MainWindow& window_;
  Workbench& workbench_;
  std::filesystem::path file_;
  QByteArray on_disk_;              ///< hash of file_ when this window read or wrote it
  std::optional<Session> pending_;  ///< shown, but for what needs its simulated run
  QByteArray saved_;                ///< essence() then; empty: of the program as it was opened
  LessonAnswers saved_answers_;
  std::shared_ptr<const Aside> aside_;
  QByteArray start_;  ///< what begin_here() found, as saved_
  mutable std::shared_ptr<const Program> hashed_;
  mutable QByteArray hash_;
  std::optional<Autosave> autosave_;
  QByteArray kept_;
  bool said_not_kept_ = false;
  std::optional<Autosave::LeftBehind> restored_;  ///< shown, and not yet among what this process keeps
  QTimer keep_timer_;
};

}  // namespace feedscope::ui
