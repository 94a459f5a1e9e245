#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

namespace feedscope::ui {

/// A backup of the session in a folder of the user, written by a process while it runs, so that nothing is
/// lost if it ends unexpectedly. Concurrent processes do not see each other's.
class Autosave {
 public:
  /// In the user's folder for application data.
  static QString usual_folder();

  /// The folder is created when needed.
  explicit Autosave(QString folder);
  /// Deletes the backup.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Base of relative paths in the backup.
  std::filesystem::path folder() const;
  /// Returns false if it cannot be written.
  bool keep(const QByteArray& session);

  struct LeftBehind {
    std::filesystem::path file;
    QDateTime written;
    std::shared_ptr<QLockFile> lock;  ///< while locked, no other process finds the file
  };
  /// The newest backup that an ended process has left in the folder and no other process has claimed.
  std::optional<LeftBehind> left_behind() const;
  static void discard(const LeftBehind& left);

 private:
  QString folder_;
  QString file_;
  std::unique_ptr<QLockFile> lock_;  ///< locked while file_ belongs to this process
};

}  // namespace feedscope::ui
