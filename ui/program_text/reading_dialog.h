#pragma once

#include <QDialog>

#include "core/program/program.h"
#include "ui/program_text/work_offsets_table.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QTableWidget;

namespace feedscope::ui {

class WholeNumberBox;

/// Asks how to read a program: its language and unit, blocks with "/", limits of loops and calls, cutter
/// radii.
class ReadingDialog : public QDialog {
  Q_OBJECT

 public:
  /// `program`: as read with `options`; null: not read yet.
  ReadingDialog(const ReadOptions& options, const Program* program, QWidget* parent = nullptr);

  /// The chosen options; usable while valid().
  ReadOptions options() const;
  /// Whether all radii are lengths of 0 or more, and all offsets are numbers.
  bool valid() const { return fault().isEmpty(); }

 private:
  void make_layout();
  void list_dialects(const Program* program);
  void list_units(const Program* program);
  void list_cutters(const ReadOptions& options, const Program* program);
  void add_cutter(const std::string& tool, std::optional<double> own, const QString& source);
  void show_options(const ReadOptions& options);
  void choose_table();
  void check();
  QString fault() const;

  QComboBox* dialect_;
  QComboBox* unit_;
  QCheckBox* skip_deleted_;
  WholeNumberBox* repeat_limit_;
  WholeNumberBox* call_depth_;
  QCheckBox* simulate_cut_off_;
  QCheckBox* wear_only_;
  QTableWidget* cutters_;
  WorkOffsetsTable* offsets_;
  QLineEdit* tool_table_;
  QComboBox* table_unit_;
  QLabel* fault_;
  QDialogButtonBox* buttons_;
};

}  // namespace feedscope::ui
