#include "ui/workbench/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace feedscope::ui {

namespace {

const QString recent_key = QStringLiteral("recent_files");

QStringList stored() {
  return QSettings().value(recent_key).toStringList();
}

}  // namespace

QStringList RecentFiles::list() {
  QStringList files;
  for (const QString& file : stored()) {
    if (QFileInfo(file).isFile()) {
      files.append(file);
    }
  }
  return files;
}

void RecentFiles::add(const QString& file) {
  QStringList files = stored();
  const QString absolute = QFileInfo(file).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  QSettings().setValue(recent_key, files.mid(0, most));
}

void RecentFiles::clear() {
  QSettings().remove(recent_key);
}

}  // namespace feedscope::ui
