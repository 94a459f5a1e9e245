#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <set>
#include <vector>

#include "ui/identification/identification_state.h"
#include "ui/workbench/workbench.h"

class QLabel;
class QListWidget;

namespace feedscope::ui {

/// Recordings of the program: its traces and tables of section times, each of them with a tick for use, and
/// their errors.
class RecordingsBox : public QWidget {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit RecordingsBox(Workbench& workbench, QWidget* parent = nullptr);

  /// The ticked traces that have been read.
  std::vector<std::shared_ptr<const Trace>> traces() const;
  std::vector<std::shared_ptr<const SectionTable>> tables() const;
  /// Whether a ticked trace is still being read.
  bool is_reading() const;
  /// Replaces a table of the same name. Throws InputError if the file is not a table of section times.
  void add_table(const std::filesystem::path& file);
  /// For another program.
  void forget_tables();
  std::vector<std::size_t> unused_traces() const;  ///< rows
  const std::vector<TableState>& all_tables() const { return tables_; }
  void set_state(const std::vector<std::size_t>& unused_traces, std::vector<TableState> tables);

  QListWidget& list() { return *list_; }
  /// Notes on the recordings, or how to obtain one.
  QString note() const;

 signals:
  void changed();

 private:
  void refresh();
  void show_notes();
  void add_row(const QString& text, const QString& tip, bool used);
  void take_tick(int row);
  QString messages_of(std::size_t row) const;
  bool is_used(std::size_t row) const;

  Workbench& workbench_;
  QListWidget* list_;
  QLabel* note_;
  std::set<int> unused_;  ///< ids of unticked traces
  std::vector<TableState> tables_;
};

}  // namespace feedscope::ui
