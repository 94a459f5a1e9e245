#pragma once

#include <QObject>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/machine/import/machine_import.h"

class QMessageBox;

namespace feedscope::ui {

class Workbench;

/// Opens machine files, and offers the machine that the configuration of a control describes.
class MachineOpening : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this; questions are asked over `window`.
  MachineOpening(Workbench& workbench, QWidget& window);

  /// Whether a file is for open(): a machine file by the end of its name, a configuration by its content.
  static bool is_machine(const std::filesystem::path& file);
  /// The current run goes to the machine of the file. For a configuration this is asked first, with how much
  /// of the machine is known; what was not understood is told when it is done.
  void open(const std::filesystem::path& file);

 signals:
  /// What a configuration does not say, or says wrong.
  void noted(Severity severity, const QString& message);
  void failed(const QString& message);

 private:
  void offer(const std::filesystem::path& file);
  QMessageBox* question(const ImportedMachine& imported, const QString& file) const;
  void use(const ImportedMachine& imported, const QString& file);

  Workbench& workbench_;
  QWidget& window_;
};

}  // namespace feedscope::ui
