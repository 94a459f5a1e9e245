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

/// How the table of a trace is read: a preview of its first rows, what each column is, and what comes out.
/// What is chosen can be kept under a name.
class TraceImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `columns`: a specification to begin with; "": none. `reason`: why this is asked; may be empty.
  TraceImportDialog(const std::filesystem::path& file, const std::string& columns, const QString& reason,
                    QWidget* parent = nullptr);

  /// As parse_trace_columns() reads it; "" where everything is found from the file.
  QString specification() const;
  /// What comes out of the first rows, or what is wrong; for people.
  QString outcome() const;
  /// Keeps what is chosen under this name; what is wrong with the name, if it is not kept.
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
  std::string head_;  ///< whole lines of its beginning
  QComboBox* presets_;
  QPushButton* keep_;
  QPushButton* forget_;
  QTableWidget* preview_;
  TraceImportFields* fields_;
  QLabel* outcome_;
  QDialogButtonBox* buttons_;
};

}  // namespace feedscope::ui
