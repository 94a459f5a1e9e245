#include "ui/session/autosave.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <utility>

#include "core/base/this_process.h"
#include "ui/session/session_file.h"

namespace feedscope::ui {
namespace {

QString lock_of(const QString& file) {
  return file + QStringLiteral(".lock");
}

/// A lock that holds however long its process lives, and not a moment longer.
std::unique_ptr<QLockFile> make_lock(const QString& file) {
  auto lock = std::make_unique<QLockFile>(lock_of(file));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

QString Autosave::usual_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
}

Autosave::Autosave(QString folder) : folder_(std::move(folder)) {
  file_ = QStringLiteral("%1/%2%3").arg(folder_).arg(process_id()).arg(QLatin1String(session_suffix));
}

Autosave::~Autosave() {
  if (lock_ != nullptr) {
    QFile::remove(file_);
  }
}

std::filesystem::path Autosave::folder() const {
  return std::filesystem::path(folder_.toStdU16String());
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
    const auto lock = make_lock(info.filePath());
    if (info.filePath() != file_ && lock->tryLock(0)) {
      return LeftBehind{std::filesystem::path(info.filePath().toStdU16String()), info.lastModified()};
    }
  }
  return std::nullopt;
}

void Autosave::discard(const LeftBehind& left) {
  const QString file = QString::fromStdU16String(left.file.u16string());
  QFile::remove(file);
  QFile::remove(lock_of(file));
}

}  // namespace feedscope::ui
