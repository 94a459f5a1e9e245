#pragma once

#include <QDialog>
#include <QTemporaryDir>
#include <QTimer>

#include "ui/report/command_process.h"
#include "ui/window/dialogs/file_writing.h"
#include "ui/window/dialogs/report_wish.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace feedscope::ui {

class LanguageBox;
class PagePreview;

/// Asks for the contents of a report, shows a preview of its pages, and writes it as PDF or HTML, all in a
/// separate process. Author, logo, paper and template are stored.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  struct Subject {
    Session session;        ///< in its current state
    QStringList run_names;  ///< of its runs
    /// Whether helpful changes, which need many simulations, are off initially, for programs that take long.
    bool takes_long = false;
  };

  /// `executable`: as of CommandProcess.
  ReportDialog(Subject subject, const QString& executable, QWidget* parent = nullptr);
  ~ReportDialog() override;

  ReportWish wish() const;
  PagePreview& preview() { return *preview_; }
  QListWidget& parts() { return *parts_; }
  QListWidget& runs() { return *runs_; }
  /// Whether save() also saves the session next to the report.
  void keep_session(bool keep);
  bool busy() const { return changed_.isActive() || previewing_.busy() || saving_.busy(); }
  /// Writes the report, PDF or HTML by the file's ending. If its session is also saved, the report contains
  /// the command that reproduces it.
  void save(const QString& file);

 signals:
  /// Message for the status bar.
  void saved(const QString& message);

 private:
  QWidget* make_form();
  void make_lists();
  void ask_for_logo();
  void ask_for_template();
  void ask_and_save();
  void make_preview();
  void show_pages();
  void show_progress(bool on);
  void remember() const;

  Subject subject_;
  QTemporaryDir folder_;
  QLineEdit* title_;
  QLineEdit* author_;
  QCheckBox* dated_;
  QLineEdit* logo_;
  QLineEdit* page_;
  LanguageBox* language_;
  QComboBox* paper_;
  QPlainTextEdit* remarks_;
  QListWidget* runs_;
  QListWidget* parts_;
  QCheckBox* with_session_;
  PagePreview* preview_;
  QProgressBar* progress_;
  StateLine* state_;
  QPushButton* save_;
  QTimer changed_;
  CommandProcess previewing_;
  FileWriting saving_;
};

}  // namespace feedscope::ui
