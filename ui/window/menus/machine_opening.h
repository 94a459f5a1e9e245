#pragma once

#include <QObject>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/machine/import/machine_import.h"

class QMessageBox;

namespace feedscope::ui {

class Workbench;

/// Opens machine files, and imports a machine from the configuration of a control.
class MachineOpening : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this; questions appear over `window`.
  MachineOpening(Workbench& workbench, QWidget& window);

  /// Whether open() accepts a file: a machine file by its ending, a configuration by its contents.
  static bool is_machine(const std::filesystem::path& file);
  /// Moves the current run to the machine of the file. For a configuration, first asks and states how much of
  /// the machine is known; values that were not understood are reported afterwards.
  void open(const std::filesystem::path& file);

 signals:
  /// A missing or wrong value in a configuration.
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
