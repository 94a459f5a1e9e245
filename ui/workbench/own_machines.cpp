#include "ui/workbench/own_machines.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace feedscope::ui {

namespace {

const QString machines_key = QStringLiteral("own_machines");

}  // namespace

QStringList OwnMachines::list() {
  QStringList files = QSettings().value(machines_key).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo(file).isFile(); });
  return files;
}

void OwnMachines::add(const QString& file) {
  QStringList files = QSettings().value(machines_key).toStringList();
  const QString absolute = QFileInfo(file).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  QSettings().setValue(machines_key, files.mid(0, most));
}

}  // namespace feedscope::ui
