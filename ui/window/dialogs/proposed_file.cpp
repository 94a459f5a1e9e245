#include "ui/window/dialogs/proposed_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <system_error>

#include "core/base/data_folder.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {
namespace {

bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::error_code ignored;
  const std::filesystem::path inner = std::filesystem::weakly_canonical(file, ignored);
  const std::filesystem::path outer = std::filesystem::weakly_canonical(folder, ignored);
  return !outer.empty() &&
         std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace

QString folder_for_files_of(const std::filesystem::path& program) {
  if (program.empty()) {
    return {};
  }
  const QString beside = QFileInfo(to_qstring(program)).absolutePath();
  if (!lies_in(program, data_folder() / "resources") && QFileInfo(beside).isWritable()) {
    return beside;
  }
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

QString proposed_file(const std::filesystem::path& program, const QString& what, const QString& ending) {
  const QString start = program.empty() ? QStringLiteral("feedscope-") + what
                                        : QStringLiteral("%1/%2-%3")
                                              .arg(folder_for_files_of(program),
                                                   QFileInfo(to_qstring(program)).completeBaseName(), what);
  QString file = QStringLiteral("%1.%2").arg(start, ending);
  for (int number = 2; QFileInfo::exists(file); ++number) {
    file = QStringLiteral("%1-%2.%3").arg(start).arg(number).arg(ending);
  }
  return file;
}

}  // namespace feedscope::ui
