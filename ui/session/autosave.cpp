#include "ui/session/autosave.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>
#include <utility>

#include "ui/session/session_file.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {
namespace {

/// A lock for exactly the lifetime of its process.
std::unique_ptr<QLockFile> make_lock(const QString& file) {
  auto lock = std::make_unique<QLockFile>(file + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

QString Autosave::usual_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
}

Autosave::Autosave(QString folder) : folder_(std::move(folder)) {
  // Not the process id, which an ended process may have had.
  const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
  file_ = QStringLiteral("%1/%2%3").arg(folder_, name, QLatin1String(session_suffix));
}

Autosave::~Autosave() {
  if (lock_ != nullptr) {
    QFile::remove(file_);
  }
}

std::filesystem::path Autosave::folder() const {
  return to_path(folder_);
}

bool Autosave::keep(const QByteArray& session) {
  if (lock_ == nullptr) {
    QDir().mkpath(folder_);
    auto lock = make_lock(file_);
    if (!lock->tryLock(0)) {
      return false;
    }
    lock_ = std::move(lock);
  }
  QSaveFile out(file_);
  return out.open(QIODevice::WriteOnly) && out.write(session) == session.size() && out.commit();
}

std::optional<Autosave::LeftBehind> Autosave::left_behind() const {
  const QDir folder(folder_);
  const QString pattern = QStringLiteral("*") + QLatin1String(session_suffix);
  for (const QFileInfo& info : folder.entryInfoList({pattern}, QDir::Files, QDir::Time)) {
    if (info.filePath() == file_) {
      continue;
    }
    std::shared_ptr<QLockFile> lock = make_lock(info.filePath());
    // The previous owner of the lock may have discarded the file since the folder was listed.
    if (lock->tryLock(0) && QFile::exists(info.filePath())) {
      return LeftBehind{to_path(info.filePath()), info.lastModified(), std::move(lock)};
    }
  }
  return std::nullopt;
}

void Autosave::discard(const LeftBehind& left) {
  QFile::remove(to_qstring(left.file));
  left.lock->unlock();  // also removes its file
}

}  // namespace feedscope::ui
