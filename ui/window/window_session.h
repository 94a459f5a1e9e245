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

/// The window's contents as a session file: opened, saved, and backed up every minute in case the process
/// ends unexpectedly.
class WindowSession : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this. There is no backup before begin_keeping().
  WindowSession(MainWindow& window, Workbench& workbench);
  ~WindowSession() override;

  /// The current state of everything.
  Session capture() const;
  /// Shows a session; parts that need a simulated run follow when it is ready.
  void show(const Session& session);

  /// Reads and shows a session file. Asks for a program that is not in the session's place, whether to
  /// continue with one that has changed since, and whether to keep work on lessons that the session does not
  /// contain. Unusable parts go to failed().
  /// Returns whether the session is shown.
  bool open(const std::filesystem::path& file);
  /// A program was opened directly: there is no session file any more.
  void forget_file();
  /// Asks for a name if there is none yet, or if `as_new`; also asks if the file has changed since this
  /// window read or wrote it. Returns false if nothing was written.
  bool save(bool as_new = false);
  /// Whether runs, annotations, identification or answers to lessons differ from the saved state, or from
  /// that after opening the program.
  bool changed() const;
  /// Treats the current contents as the initial ones of a lesson or command line, without work of the user.
  void begin_here() { start_ = essence(); }
  /// Stores the window's contents, to be restored after a lesson has replaced them. Does nothing without a
  /// program, with that of another lesson, or if something is already stored.
  void set_aside();
  /// Restores the stored contents with their session file; the layout is unchanged. Does nothing without any.
  void bring_back();
  /// Asks whether to save changes, including those in the stored contents. Returns false if the user does not
  /// want to continue.
  bool may_go();
  const std::filesystem::path& file() const { return file_; }

  struct Aside;
  /// State with which another window on the same workbench continues.
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

  /// Makes a backup now, and again after each `pause`. An unwritable folder is reported once.
  void begin_keeping(std::chrono::milliseconds pause = std::chrono::minutes(1));
  /// Offers the backup of a process that ended unexpectedly.
  void offer_left_behind();

 signals:
  void file_changed();
  /// Whether contents are now stored.
  void aside_changed(bool there);
  /// For the user: unusable parts of the session, or the result of an action.
  void noticed(const QString& message);
  void failed(const QString& message);

 private:
  /// Settings of all views, without their contents.
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
  /// Work on lessons that the session does not contain, if the user wants to keep it.
  LessonWork lessons_to_keep(const Session& session) const;
  QByteArray essence() const;
  const QByteArray& program_hash() const;
  /// `kept`: from lessons_to_keep().
  void show_file(const std::filesystem::path& file, ReadSession read, const LessonWork& kept,
                 const QByteArray& on_disk);
  /// Records that the contents are those of the file, whose hash is `on_disk`.
  void now_in(const std::filesystem::path& file, const QByteArray& on_disk);
  /// Initially the name of a program or session file. Empty if the user cancels.
  std::filesystem::path ask_for_name(const std::filesystem::path& of);
  /// The file to save to: this one, or the user's choice if someone else has written to it. Empty: none.
  std::filesystem::path file_after_conflict();

  MainWindow& window_;
  Workbench& workbench_;
  std::filesystem::path file_;
  QByteArray on_disk_;              ///< hash of file_ when this window last read or wrote it
  std::optional<Session> pending_;  ///< shown, except for parts that need its simulated run
  QByteArray saved_;                ///< essence() at that time; empty: that after opening the program
  LessonAnswers saved_answers_;
  std::shared_ptr<const Aside> aside_;
  QByteArray start_;  ///< state at begin_here(), like saved_
  mutable std::shared_ptr<const Program> hashed_;
  mutable QByteArray hash_;
  std::optional<Autosave> autosave_;
  QByteArray kept_;
  bool said_not_kept_ = false;
  std::optional<Autosave::LeftBehind> restored_;  ///< shown, and not yet in this process's backup
  QTimer keep_timer_;
};

}  // namespace feedscope::ui
