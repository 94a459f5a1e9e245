#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

namespace feedscope::ui {

/// A session that a process keeps in a folder of the user's while it runs, so that nothing is lost if it ends
/// without having been asked to. Processes at work at the same time do not see each other's.
class Autosave {
 public:
  /// In the user's folder for data of the application.
  static QString usual_folder();

  /// The folder is made when it is needed.
  explicit Autosave(QString folder);
  /// What was kept goes.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Where relative paths in what is kept count from.
  std::filesystem::path folder() const;
  /// False if it cannot be written.
  bool keep(const QByteArray& session);

  struct LeftBehind {
    std::filesystem::path file;
    QDateTime written;
    std::shared_ptr<QLockFile> lock;  ///< while it is held, no other process finds the file
  };
  /// The newest that a process which is gone has left in the folder, and that no other process has found.
  std::optional<LeftBehind> left_behind() const;
  static void discard(const LeftBehind& left);

 private:
  QString folder_;
  QString file_;
  std::unique_ptr<QLockFile> lock_;  ///< held while file_ is this process's
};

}  // namespace feedscope::ui
