#include "ui/window/window_session.h"

#include <QApplication>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "core/base/error.h"
#include "ui/charts/charts_panel.h"
#include "ui/circular/circular_view.h"
#include "ui/identification/identification_view.h"
#include "ui/language/in_language.h"
#include "ui/lessons/lesson_view.h"
#include "ui/load/load_view.h"
#include "ui/program_text/program_panel.h"
#include "ui/shared/paths.h"
#include "ui/window/dialogs/proposed_file.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/presentation.h"
#include "ui/window/panels/saved_layout.h"

namespace feedscope::ui {

namespace {

/// Works for names that the system refuses, too.
bool is_there(const std::filesystem::path& file) {
  std::error_code none;
  return std::filesystem::exists(file, none);
}

QString message_of(const InputError& error) {
  return failure_text(error);
}

}  // namespace

/// Contents that a lesson has replaced.
struct WindowSession::Aside {
  Session session;
  Kept kept;
  bool changed = false;  ///< and unsaved
};

WindowSession::WindowSession(MainWindow& window, Workbench& workbench)
    : QObject(&window), window_(window), workbench_(workbench) {
  connect(&workbench_, &Workbench::run_changed, this, &WindowSession::apply_to_run);
  connect(&keep_timer_, &QTimer::timeout, this, &WindowSession::keep);
}

WindowSession::~WindowSession() {
  forget_restored();
}

Session WindowSession::capture() const {
  Session session = view();
  session.program = std::filesystem::absolute(workbench_.file()).lexically_normal();
  session.program_hash = program_hash();
  session.reading = workbench_.reading();
  session.runs = workbench_.runs().items();
  session.current_run = workbench_.runs().current();
  session.error_bound = workbench_.runs().error_bound();
  session.annotations = workbench_.annotations().items();
  session.traces = workbench_.traces().items();
  return session;
}

Session WindowSession::view() const {
  Session session;
  if (pending_) {
    session.cursor = pending_->cursor;
    session.scene = pending_->scene;
    session.scenes = pending_->scenes;
    session.charts = pending_->charts;
    session.circular = pending_->circular;
  } else {
    session.cursor = workbench_.cursor().valid() ? workbench_.cursor().state().time : 0;
    session.scene = window_.scene().state();
    session.scenes = window_.scenes().state();
    session.charts = window_.part<ChartsPanel>().state();
    session.circular = window_.part<CircularView>().state();
  }
  session.identification = identification();
  session.load = window_.part<LoadView>().setup();
  session.lessons = desk().all_work();
  session.lessons_unlocked = desk().unlocked();
  session.layout = window_.layout_to_keep();
  session.presentation = window_.presentation().on();
  session.theme = theme_of(QApplication::palette());
  session.program_font_size = window_.presentation().usual_program_type();
  return session;
}

IdentificationState WindowSession::identification() const {
  return window_.part<IdentificationView>().state();
}

LessonDesk& WindowSession::desk() const {
  return window_.part<LessonView>().desk();
}

void WindowSession::show(const Session& session) {
  drop_aside();
  desk().unlock(session.lessons_unlocked);
  desk().set_all_work(session.lessons);
  show_contents(session);
  show_layout(session);
}

void WindowSession::show_contents(const Session& session) {
  workbench_.open(session.program, session.runs, session.current_run, session.reading, session.load);
  workbench_.runs().set_error_bound(session.error_bound);
  workbench_.annotations().replace(session.annotations);
  workbench_.traces().replace(session.traces);
  window_.part<IdentificationView>().set_state(session.identification);  // needs no run
  pending_ = session;
}

void WindowSession::set_aside() {
  if (aside_ != nullptr || workbench_.program() == nullptr || workbench_.of_lesson()) {
    return;
  }
  aside_ = std::make_shared<const Aside>(Aside{capture(), hand_over(), contents_changed()});
  pending_.reset();
  file_.clear();  // so that the lesson does not overwrite it
  on_disk_.clear();
  saved_.clear();
  start_.clear();
  emit file_changed();
  emit aside_changed(true);
}

void WindowSession::bring_back() {
  const auto aside = std::exchange(aside_, nullptr);
  if (aside == nullptr) {
    return;
  }
  show_contents(aside->session);
  file_ = aside->kept.file;
  saved_ = aside->kept.saved;
  start_ = aside->kept.start;
  on_disk_ = aside->kept.on_disk;
  emit file_changed();
  emit aside_changed(false);
}

void WindowSession::drop_aside() {
  if (std::exchange(aside_, nullptr) != nullptr) {
    emit aside_changed(false);
  }
}

void WindowSession::show_layout(const Session& session) {
  Presentation& presentation = window_.presentation();
  presentation.set_on(false);
  if (session.program_font_size) {
    window_.part<ProgramPanel>().view().set_font_size(*session.program_font_size);
  }
  if (session.presentation) {
    presentation.show_over(checked_state(session.layout));
  } else {
    window_.restore_layout(session.layout);
  }
}

WindowSession::Kept WindowSession::hand_over() const {
  return {view(), file_, saved_, start_, on_disk_, saved_answers_, desk().covers(), aside_};
}

void WindowSession::take_over(const Kept& kept) {
  file_ = kept.file;
  saved_ = kept.saved;
  start_ = kept.start;
  on_disk_ = kept.on_disk;
  aside_ = kept.aside;
  emit aside_changed(aside_ != nullptr);
  show_layout(kept.view);
  window_.part<LoadView>().set_setup(kept.view.load);
  desk().unlock(kept.view.lessons_unlocked);
  desk().set_covers(kept.covers);
  desk().set_all_work(kept.view.lessons);
  saved_answers_ = kept.answers;
  window_.part<IdentificationView>().set_state(kept.view.identification);
  pending_ = kept.view;
  apply_to_run();
  emit file_changed();
}

/// Applies ranges and camera, which require a path.
void WindowSession::apply_to_run() {
  if (!pending_ || workbench_.shown() == nullptr) {
    return;
  }
  const Session session = *std::exchange(pending_, std::nullopt);
  window_.scene().set_state(session.scene);
  window_.scenes().set_state(session.scenes);
  window_.part<ChartsPanel>().set_state(session.charts);
  window_.part<CircularView>().set_state(session.circular);
  workbench_.cursor().set_time(session.cursor);
}

bool WindowSession::open(const std::filesystem::path& file) {
  try {
    const QByteArray on_disk = hash_of(file);  // first: later writes are by others
    ReadSession read = read_session_file(file);
    if (find_program(file, read.session) && accept_changed_program(read.session)) {
      const LessonWork kept = lessons_to_keep(read.session);
      show_file(file, std::move(read), kept, on_disk);
      return true;
    }
  } catch (const InputError& error) {
    emit failed(message_of(error));
  }
  return false;
}

void WindowSession::show_file(const std::filesystem::path& file, ReadSession read, const LessonWork& kept,
                              const QByteArray& on_disk) {
  read.session.lessons.insert(kept.begin(), kept.end());
  show(read.session);
  for (const QString& note : read.notes) {
    emit noticed(note);
  }
  const LessonAnswers saved_before = std::exchange(saved_answers_, {});
  now_in(file, on_disk);
  std::erase_if(saved_answers_,
                [&](const auto& answer) {  // answers of another file are saved there, or not at all
                  const auto before = saved_before.find(answer.first);
                  return kept.contains(answer.first) &&
                         (before == saved_before.end() || before->second != answer.second);
                });
}

LessonWork WindowSession::lessons_to_keep(const Session& session) const {
  LessonWork other = of_other_lessons(desk().all_work(), session.lessons);
  const std::size_t count = lesson_count(other);
  if (count == 0) {
    return {};
  }
  const QMessageBox::StandardButton answer = QMessageBox::question(
      &window_, tr("Keep what was done in other lessons?"),
      count == 1
          ? tr("Answers or tried values of a lesson are in the window of which this session holds nothing. "
               "Keep them beside what it holds?")
          : tr("Answers or tried values of %1 lessons are in the window of which this session holds "
               "nothing. Keep them beside what it holds?")
                .arg(count),
      QMessageBox::Yes | QMessageBox::No, QMessageBox::Yes);
  return answer == QMessageBox::Yes ? std::move(other) : LessonWork();
}

void WindowSession::now_in(const std::filesystem::path& file, const QByteArray& on_disk) {
  file_ = file;
  on_disk_ = on_disk;
  saved_ = essence();
  saved_answers_ = desk().answers();
  emit file_changed();
}

bool WindowSession::find_program(const std::filesystem::path& file, Session& session) {
  if (is_there(session.program)) {
    return true;
  }
  const QString missing = to_qstring(session.program);
  QMessageBox::information(
      &window_, tr("Program not found"),
      tr("The session's program %1 was not found. Select its new location.").arg(missing));
  const QString found =
      QFileDialog::getOpenFileName(&window_, tr("Where is %1?").arg(to_qstring(session.program.filename())),
                                   to_qstring(session.program.parent_path()));
  if (found.isEmpty()) {
    emit failed(tr("Session %1 is not opened: its program %2 was not found.").arg(to_qstring(file), missing));
    return false;
  }
  session.program = to_path(found);
  return true;
}

bool WindowSession::accept_changed_program(const Session& session) {
  if (session.program_hash.isEmpty() || hash_of(session.program) == session.program_hash) {
    return true;
  }
  return QMessageBox::question(&window_, tr("Program changed"),
                               tr("%1 has changed since the session was saved. Annotations may be at other "
                                  "places, and numbers may differ. Open it anyway?")
                                   .arg(to_qstring(session.program))) == QMessageBox::Yes;
}

void WindowSession::forget_file() {
  drop_aside();
  pending_.reset();
  file_.clear();
  on_disk_.clear();
  saved_.clear();
  start_.clear();
  emit file_changed();
}

bool WindowSession::save(bool as_new) {
  if (workbench_.program() == nullptr) {
    emit failed(tr("There is nothing to save: open a program first."));
    return false;
  }
  const std::filesystem::path file = as_new || file_.empty()
                                         ? ask_for_name(file_.empty() ? workbench_.file() : file_)
                                         : file_after_conflict();
  if (file.empty()) {
    return false;
  }
  try {
    write_session(capture(), file);
  } catch (const InputError& error) {
    emit failed(message_of(error));
    return false;
  }
  now_in(file, hash_of(file));
  emit noticed(tr("Saved as %1.").arg(to_qstring(file)));
  return true;
}

std::filesystem::path WindowSession::ask_for_name(const std::filesystem::path& of) {
  const std::filesystem::path proposed = std::filesystem::path(of).replace_extension(session_suffix);
  QFileDialog dialog(&window_, tr("Save session as"), folder_for_files_of(of),
                     tr("Feedscope sessions (*%1)").arg(session_suffix));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(session_suffix);  // so that it asks before overwriting a file
  dialog.selectFile(to_qstring(proposed.filename()));
  return dialog.exec() == QDialog::Accepted ? to_path(dialog.selectedFiles().first())
                                            : std::filesystem::path();
}

std::filesystem::path WindowSession::file_after_conflict() {
  if (!is_there(file_) || hash_of(file_) == on_disk_) {
    return file_;
  }
  QMessageBox box(
      QMessageBox::Warning, tr("Session changed"),
      tr("%1 has been written by another window or program since this window opened or saved it. Save this "
         "session under another name, or overwrite what is in the file now?")
          .arg(to_qstring(file_)),
      QMessageBox::Cancel, &window_);
  QPushButton* save_as = box.addButton(tr("Save &as …"), QMessageBox::AcceptRole);
  const QPushButton* overwrite = box.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
  box.setDefaultButton(save_as);
  box.exec();
  if (box.clickedButton() == save_as) {
    return ask_for_name(file_);
  }
  return box.clickedButton() == overwrite ? file_ : std::filesystem::path();
}

/// Runs, annotations, traces, import options, section times and identification, without the state of views.
QByteArray WindowSession::essence() const {
  Session session;
  session.program = workbench_.file();
  session.reading = workbench_.reading();
  session.runs = workbench_.runs().items();
  session.annotations = workbench_.annotations().items();
  session.traces = workbench_.traces().items();
  const IdentificationState now = identification();
  session.identification.tables = now.tables;
  session.identification.result.outcome = now.result.outcome;
  const QJsonObject json = to_json(session, {});
  return QJsonDocument(QJsonArray{json["runs"], json["annotations"], json["traces"], json["reading"],
                                  json["identification"]})
      .toJson(QJsonDocument::Compact);
}

bool WindowSession::changed() const {
  return desk().answers() != saved_answers_ || contents_changed();
}

bool WindowSession::contents_changed() const {
  if (file_.empty() && !start_.isEmpty() && essence() == start_) {
    return false;
  }
  if (file_.empty()) {
    const IdentificationState now = identification();
    return !now.tables.empty() || now.result.outcome != nullptr ||
           !workbench_.annotations().items().empty() || workbench_.runs().items().size() > 1 ||
           !(workbench_.reading() == ReadOptions());
  }
  return essence() != saved_;
}

/// Answers and tries belong to the learner, not to the contents that the lesson has replaced.
Session WindowSession::aside_with_work() const {
  Session session = aside_->session;
  session.lessons = desk().all_work();
  return session;
}

bool WindowSession::save_aside() {
  const bool own_file = !aside_->kept.file.empty() && is_there(aside_->kept.file) &&
                        hash_of(aside_->kept.file) == aside_->kept.on_disk;
  const std::filesystem::path file = own_file ? aside_->kept.file : ask_for_name(aside_->session.program);
  if (file.empty()) {
    return false;
  }
  try {
    write_session(aside_with_work(), file);
  } catch (const InputError& error) {
    emit failed(message_of(error));
    return false;
  }
  emit noticed(tr("Saved as %1.").arg(to_qstring(file)));
  return true;
}

bool WindowSession::may_go() {
  if (aside_ != nullptr && aside_->changed) {
    const QMessageBox::StandardButton answer = QMessageBox::question(
        &window_, tr("Save the session?"),
        tr("Runs and annotations of %1, which a lesson has replaced in the window, have not been saved.")
            .arg(to_qstring(aside_->session.program.filename())),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Cancel || (answer == QMessageBox::Save && !save_aside())) {
      return false;
    }
  }
  if (!changed()) {
    return true;
  }
  const QMessageBox::StandardButton answer = QMessageBox::question(
      &window_, tr("Save the session?"),
      workbench_.program() == nullptr
          ? tr("Answers to lessons have not been saved.")
          : tr("Runs, annotations, what was identified or answers to lessons with %1 have not been saved.")
                .arg(to_qstring(workbench_.file().filename())),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Save ? save() : answer == QMessageBox::Discard;
}

void WindowSession::begin_keeping(std::chrono::milliseconds pause) {
  autosave_.emplace(Autosave::usual_folder());
  keep_timer_.start(pause);
  keep();
}

void WindowSession::keep() {
  if (workbench_.program() == nullptr) {
    return;
  }
  const QByteArray bytes = session_bytes(aside_ != nullptr && aside_->changed ? aside_with_work() : capture(),
                                         autosave_->folder());
  if (bytes == kept_) {
    return;
  }
  if (autosave_->keep(bytes)) {
    kept_ = bytes;
    said_not_kept_ = false;
    forget_restored();
  } else if (!std::exchange(said_not_kept_, true)) {
    emit failed(
        tr("What is open cannot be kept in %1 and will be lost if Feedscope ends unexpectedly. Save the "
           "session, or make that folder writable.")
            .arg(to_qstring(autosave_->folder())));
  }
}

void WindowSession::forget_restored() {
  if (restored_) {
    Autosave::discard(*restored_);
    restored_.reset();
  }
}

void WindowSession::offer_left_behind() {
  auto left = autosave_->left_behind();
  if (!left) {
    return;
  }
  const QString when = QLocale().toString(left->written, QLocale::ShortFormat);
  const auto answer = QMessageBox::question(
      &window_, tr("Restore the last session?"),
      tr("Feedscope ended unexpectedly. Restore what was open at that time (%1)?").arg(when));
  if (answer != QMessageBox::Yes) {
    Autosave::discard(*left);
  } else if (open(left->file)) {
    file_.clear();  // to be saved under a name of the user's
    on_disk_.clear();
    saved_.clear();
    saved_answers_.clear();
    restored_ = std::move(left);
    emit file_changed();
  }
}

const QByteArray& WindowSession::program_hash() const {
  if (hashed_ != workbench_.program()) {
    hashed_ = workbench_.program();
    hash_ = hash_of(workbench_.file());
  }
  return hash_;
}

}  // namespace feedscope::ui
