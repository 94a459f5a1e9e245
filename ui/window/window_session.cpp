#include "ui/window/window_session.h"

#include <QApplication>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QMessageBox>
#include <chrono>
#include <utility>

#include "core/base/error.h"
#include "ui/charts/charts_panel.h"
#include "ui/program_text/program_panel.h"
#include "ui/shared/paths.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {

namespace {

constexpr std::chrono::seconds between_keeping(60);

QString message_of(const InputError& error) {
  return QString::fromUtf8(error.what());
}

}  // namespace

WindowSession::WindowSession(MainWindow& window, Workbench& workbench)
    : QObject(&window), window_(window), workbench_(workbench) {
  connect(&workbench_, &Workbench::run_changed, this, &WindowSession::apply_to_run);
  keep_timer_.setInterval(between_keeping);
  connect(&keep_timer_, &QTimer::timeout, this, &WindowSession::keep);
}

Session WindowSession::capture() const {
  Session session = view();
  session.program = std::filesystem::absolute(workbench_.file()).lexically_normal();
  session.program_hash = program_hash();
  session.reading = workbench_.reading();
  session.runs = workbench_.runs().items();
  session.current_run = workbench_.runs().current();
  session.annotations = workbench_.annotations().items();
  return session;
}

Session WindowSession::view() const {
  Session session;
  session.cursor = workbench_.cursor().valid() ? workbench_.cursor().state().time : 0;
  session.scene = window_.scene().state();
  session.scenes = window_.scenes().state();
  session.charts = window_.part<ChartsPanel>().state();
  session.layout = window_.saveState();
  session.theme = theme_of(QApplication::palette());
  session.program_font_size = window_.part<ProgramPanel>().view().font_size();
  return session;
}

void WindowSession::show(const Session& session) {
  workbench_.open(session.program, session.runs, session.current_run, session.reading);
  workbench_.annotations().replace(session.annotations);
  window_.restore_layout(session.layout);
  if (session.program_font_size) {
    window_.part<ProgramPanel>().view().set_font_size(*session.program_font_size);
  }
  pending_ = session;
}

void WindowSession::take_over(const Kept& kept) {
  file_ = kept.file;
  saved_ = kept.saved;
  start_ = kept.start;
  window_.restore_layout(kept.view.layout);
  pending_ = kept.view;
  apply_to_run();
  emit file_changed();
}

/// Ranges and camera belong to a path: there must be one before they can be set.
void WindowSession::apply_to_run() {
  if (!pending_ || workbench_.shown() == nullptr) {
    return;
  }
  const Session session = *std::exchange(pending_, std::nullopt);
  window_.scene().set_state(session.scene);
  window_.scenes().set_state(session.scenes);
  window_.part<ChartsPanel>().set_state(session.charts);
  workbench_.cursor().set_time(session.cursor);
}

void WindowSession::open(const std::filesystem::path& file) {
  try {
    ReadSession read = read_session_file(file);
    if (find_program(read.session) && accept_changed_program(read.session)) {
      show_file(file, read);
    }
  } catch (const InputError& error) {
    emit failed(message_of(error));
  }
}

void WindowSession::show_file(const std::filesystem::path& file, const ReadSession& read) {
  show(read.session);
  file_ = file;
  saved_ = essence();
  for (const QString& note : read.notes) {
    emit noticed(note);
  }
  emit file_changed();
}

bool WindowSession::find_program(Session& session) {
  if (std::filesystem::exists(session.program)) {
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
    emit failed(tr("The session is not opened: its program %1 was not found.").arg(missing));
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
  pending_.reset();
  file_.clear();
  saved_.clear();
  start_.clear();
  emit file_changed();
}

bool WindowSession::save(bool as_new) {
  if (workbench_.program() == nullptr) {
    emit failed(tr("There is nothing to save: open a program first."));
    return false;
  }
  std::filesystem::path file = file_;
  if (as_new || file.empty()) {
    const std::filesystem::path proposed =
        file.empty() ? std::filesystem::path(workbench_.file()).replace_extension(session_suffix) : file;
    file = to_path(QFileDialog::getSaveFileName(&window_, tr("Save session as"), to_qstring(proposed),
                                                tr("Feedscope sessions (*%1)").arg(session_suffix)));
    if (file.empty()) {
      return false;
    }
    if (!file.has_extension()) {
      file += session_suffix;
    }
  }
  try {
    write_session(capture(), file);
  } catch (const InputError& error) {
    emit failed(message_of(error));
    return false;
  }
  file_ = file;
  saved_ = essence();
  emit file_changed();
  emit noticed(tr("Saved as %1.").arg(to_qstring(file)));
  return true;
}

/// Runs, annotations and import options, without which place is looked at.
QByteArray WindowSession::essence() const {
  Session session;
  session.program = workbench_.file();
  session.reading = workbench_.reading();
  session.runs = workbench_.runs().items();
  session.annotations = workbench_.annotations().items();
  const QJsonObject json = to_json(session, {});
  return QJsonDocument(QJsonArray{json["runs"], json["annotations"], json["reading"]})
      .toJson(QJsonDocument::Compact);
}

bool WindowSession::changed() const {
  if (file_.empty() && !start_.isEmpty() && essence() == start_) {
    return false;
  }
  if (file_.empty()) {
    return !workbench_.annotations().items().empty() || workbench_.runs().items().size() > 1 ||
           !(workbench_.reading() == ReadOptions());
  }
  return essence() != saved_;
}

bool WindowSession::may_go() {
  if (!changed()) {
    return true;
  }
  const QMessageBox::StandardButton answer = QMessageBox::question(
      &window_, tr("Save the session?"),
      tr("Runs and annotations of %1 have not been saved.").arg(to_qstring(workbench_.file().filename())),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Save ? save() : answer == QMessageBox::Discard;
}

void WindowSession::begin_keeping() {
  autosave_.emplace(Autosave::usual_folder());
  keep_timer_.start();
}

void WindowSession::keep() {
  if (workbench_.program() == nullptr || pending_) {
    return;
  }
  const QByteArray bytes = session_bytes(capture(), autosave_->folder());
  if (bytes != kept_ && autosave_->keep(bytes)) {
    kept_ = bytes;
  }
}

void WindowSession::offer_left_behind() {
  const auto left = autosave_->left_behind();
  if (!left) {
    return;
  }
  const QString when = QLocale().toString(left->written, QLocale::ShortFormat);
  const auto answer = QMessageBox::question(
      &window_, tr("Restore the last session?"),
      tr("Feedscope ended unexpectedly. Restore what was open at that time (%1)?").arg(when));
  if (answer == QMessageBox::Yes) {
    open(left->file);
    file_.clear();  // it is to be saved under a name of the user's
    saved_.clear();
    emit file_changed();
  }
  Autosave::discard(*left);
}

const QByteArray& WindowSession::program_hash() const {
  if (hashed_ != workbench_.program()) {
    hashed_ = workbench_.program();
    hash_ = hash_of(workbench_.file());
  }
  return hash_;
}

}  // namespace feedscope::ui
