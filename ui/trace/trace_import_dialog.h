#pragma once

#include <QDialog>
#include <filesystem>
#include <string>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace feedscope::ui {

class TraceImportFields;

/// Asks how to read the table of a trace: shows its first rows, the meaning of each column, and the result.
/// The choices can be saved under a name.
class TraceImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `columns`: initial specification; "": none. `reason`: reason for asking; may be empty.
  TraceImportDialog(const std::filesystem::path& file, const std::string& columns, const QString& reason,
                    QWidget* parent = nullptr);

  /// Specification for parse_trace_columns(); "" if everything is detected from the file.
  QString specification() const;
  /// The result for the first rows, or an error; for people.
  QString outcome() const;
  /// Saves the choices under this name; returns an error in the name if it does not.
  QString keep_as(const QString& name);

  TraceImportFields& fields() { return *fields_; }
  QTableWidget& preview() { return *preview_; }
  QComboBox& presets() { return *presets_; }

 private:
  void list_presets();
  void use_preset(int index);
  void ask_name();
  void refresh();
  bool show_rows();

  std::string name_;  ///< of the file, for messages
  std::string head_;  ///< whole lines of its start
  QComboBox* presets_;
  QPushButton* keep_;
  QPushButton* forget_;
  QTableWidget* preview_;
  TraceImportFields* fields_;
  QLabel* outcome_;
  QDialogButtonBox* buttons_;
};

}  // namespace feedscope::ui
