#include "ui/window_session.h"

#include <QApplication>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QMessageBox>
#include <chrono>
#include <utility>

#include "core/base/error.h"
#include "ui/main_window.h"

namespace feedscope::ui {

namespace {

constexpr std::chrono::seconds between_keeping(60);

QString to_qstring(const std::filesystem::path& path) {
  return QString::fromStdU16String(path.u16string());
}

std::filesystem::path to_path(const QString& file) {
  return std::filesystem::path(file.toStdU16String());
}

QString message_of(const InputError& error) {
  return QString::fromUtf8(error.what());
}

}  // namespace

WindowSession::WindowSession(MainWindow& window, Workbench& model)
    : QObject(&window), window_(window), model_(model) {
  connect(&model_, &Workbench::run_changed, this, &WindowSession::apply_to_run);
  keep_timer_.setInterval(between_keeping);
  connect(&keep_timer_, &QTimer::timeout, this, &WindowSession::keep);
}

Session WindowSession::capture() const {
  Session session;
  session.program = std::filesystem::absolute(model_.file()).lexically_normal();
  session.program_hash = program_hash();
  session.reading = model_.reading();
  session.runs = model_.runs().items();
  session.current_run = model_.runs().current();
  session.cursor = model_.cursor().valid() ? model_.cursor().state().time : 0;
  session.scene = window_.scene().state();
  session.scenes = window_.scenes().state();
  session.charts = window_.charts().state();
  session.annotations = model_.annotations().items();
  session.layout = window_.saveState();
  session.theme = theme_of(QApplication::palette());
  session.program_font_size = window_.program().font_size();
  return session;
}

void WindowSession::show(const Session& session) {
  model_.open(session.program, session.runs, session.current_run, session.reading);
  model_.annotations().replace(session.annotations);
  window_.restore_layout(session.layout);
  if (session.program_font_size) {
    window_.program().set_font_size(*session.program_font_size);
  }
  pending_ = session;
}

/// Ranges and camera belong to a path: there must be one before they can be set.
void WindowSession::apply_to_run() {
  if (!pending_ || model_.shown() == nullptr) {
    return;
  }
  const Session session = *std::exchange(pending_, std::nullopt);
  window_.scene().set_state(session.scene);
  window_.scenes().set_state(session.scenes);
  window_.charts().set_state(session.charts);
  model_.cursor().set_time(session.cursor);
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
      tr("%1 is not there, on which the session was made. Show where the program is now.").arg(missing));
  const QString found =
      QFileDialog::getOpenFileName(&window_, tr("Where is %1?").arg(to_qstring(session.program.filename())),
                                   to_qstring(session.program.parent_path()));
  if (found.isEmpty()) {
    emit failed(tr("The session is not opened: its program %1 is not there.").arg(missing));
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
                               tr("%1 has changed since the session was saved. Annotations may stand "
                                  "elsewhere, and figures may "
                                  "differ. Open it all the same?")
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
  if (model_.program() == nullptr) {
    emit failed(tr("There is nothing to save yet: open a program first."));
    return false;
  }
  std::filesystem::path file = file_;
  if (as_new || file.empty()) {
    const std::filesystem::path proposed =
        file.empty() ? std::filesystem::path(model_.file()).replace_extension(session_suffix) : file;
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

/// Runs, annotations and reading options, without which place is looked at.
QByteArray WindowSession::essence() const {
  Session session;
  session.program = model_.file();
  session.reading = model_.reading();
  session.runs = model_.runs().items();
  session.annotations = model_.annotations().items();
  const QJsonObject json = to_json(session, {});
  return QJsonDocument(QJsonArray{json["runs"], json["annotations"], json["reading"]})
      .toJson(QJsonDocument::Compact);
}

bool WindowSession::changed() const {
  if (file_.empty() && !start_.isEmpty() && essence() == start_) {
    return false;
  }
  if (file_.empty()) {
    return !model_.annotations().items().empty() || model_.runs().items().size() > 1 ||
           !(model_.reading() == ReadOptions());
  }
  return essence() != saved_;
}

bool WindowSession::may_go() {
  if (!changed()) {
    return true;
  }
  const QMessageBox::StandardButton answer = QMessageBox::question(
      &window_, tr("Save the session?"),
      tr("Runs and annotations of %1 are not saved.").arg(to_qstring(model_.file().filename())),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Save ? save() : answer == QMessageBox::Discard;
}

void WindowSession::begin_keeping() {
  autosave_.emplace(Autosave::usual_folder());
  keep_timer_.start();
}

void WindowSession::keep() {
  if (model_.program() == nullptr || pending_) {
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
      &window_, tr("Bring back what was open?"),
      tr("Feedscope ended unexpectedly. Bring back what was open then (%1)?").arg(when));
  if (answer == QMessageBox::Yes) {
    open(left->file);
    file_.clear();  // it is to be saved under a name of the user's
    saved_.clear();
    emit file_changed();
  }
  Autosave::discard(*left);
}

const QByteArray& WindowSession::program_hash() const {
  if (hashed_ != model_.program()) {
    hashed_ = model_.program();
    hash_ = hash_of(model_.file());
  }
  return hash_;
}

}  // namespace feedscope::ui
