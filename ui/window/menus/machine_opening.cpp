#include "ui/window/menus/machine_opening.h"

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/shared/paths.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

bool is_machine_file(const std::filesystem::path& file) {
  return to_qstring(file).endsWith(QStringLiteral(".toml"), Qt::CaseInsensitive);
}

/// As format(), in the user's language.
QString note_text(const Diagnostic& note, const QString& file) {
  QString place = note.file.empty() ? file : QString::fromStdString(note.file);
  if (note.line > 0) {
    place += QStringLiteral(":%1").arg(note.line);
  }
  const QString hint = note.hint.empty() ? QString() : QStringLiteral(" (%1)").arg(in_language(note.hint));
  return QStringLiteral("%1: %2: %3 [%4]%5")
      .arg(place, core_text(std::string(to_string(note.severity))), in_language(note.message),
           QString::fromStdString(note.code), hint);
}

}  // namespace

MachineOpening::MachineOpening(Workbench& workbench, QWidget& window)
    : QObject(&window), workbench_(workbench), window_(window) {}

bool MachineOpening::is_machine(const std::filesystem::path& file) {
  return is_machine_file(file) || !configuration_kind_of(file).empty();
}

void MachineOpening::open(const std::filesystem::path& file) {
  if (is_machine_file(file)) {
    workbench_.choose_machine(to_qstring(file));
  } else {
    offer(file);
  }
}

void MachineOpening::offer(const std::filesystem::path& file) {
  try {
    const ImportedMachine imported = import_machine(file, machine_file_settings());
    const QString name = to_qstring(file.filename());
    QMessageBox* box = question(imported, name);
    connect(box, &QMessageBox::accepted, this, [this, imported, name] { use(imported, name); });
    box->open();
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

QMessageBox* MachineOpening::question(const ImportedMachine& imported, const QString& file) const {
  const auto assumed =
      std::ranges::count_if(imported.machine.provenance, [](const auto& one) { return one.second.assumed; });
  const auto known = static_cast<std::ptrdiff_t>(imported.machine.provenance.size()) - assumed;
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("Import machine"),
      tr("%1 is the configuration of a control: %2.\nUse the machine that it describes for the current run?")
          .arg(file, core_text(imported.kind)),
      QMessageBox::NoButton, &window_);
  box->setAttribute(Qt::WA_DeleteOnClose);
  QString text = tr("Numbers from the file: %1, assumed: %2.").arg(known).arg(assumed);
  QStringList notes;
  for (const Diagnostic& note : imported.notes) {
    notes.append(note_text(note, file));
  }
  if (!notes.isEmpty()) {
    text += QLatin1Char(' ') + tr("Notes: %1.").arg(notes.size());
    box->setDetailedText(notes.join('\n'));
  }
  box->setInformativeText(text);
  box->setDefaultButton(box->addButton(tr("&Import"), QMessageBox::AcceptRole));
  box->addButton(QMessageBox::Cancel);
  return box;
}

void MachineOpening::use(const ImportedMachine& imported, const QString& file) {
  workbench_.use_machine(imported.machine);
  for (const Diagnostic& note : imported.notes) {
    emit noted(note.severity, note_text(note, file));
  }
  emit noted(Severity::info,
             tr("Machine imported from %1. File > Machine > Save machine as … keeps it as a machine file.")
                 .arg(file));
}

}  // namespace feedscope::ui
