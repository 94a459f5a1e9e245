#pragma once

#include <QDialog>
#include <QTemporaryDir>
#include <QTimer>

#include "ui/report/command_process.h"
#include "ui/window/file_writing.h"
#include "ui/window/report_wish.h"

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

/// Asks what a report is to hold, shows its pages as it is asked, and writes it as PDF or HTML, all of that
/// in a process of its own. Author, logo, paper and template are remembered.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  struct Subject {
    Session session;        ///< as it is shown now
    QStringList run_names;  ///< of its runs
    /// What would help is simulated many times over; for programs that take long it is off at first.
    bool takes_long = false;
  };

  /// `executable`: as of CommandProcess.
  ReportDialog(Subject subject, const QString& executable, QWidget* parent = nullptr);
  ~ReportDialog() override;

  ReportWish wish() const;
  PagePreview& preview() { return *preview_; }
  QListWidget& parts() { return *parts_; }
  QListWidget& runs() { return *runs_; }
  /// Whether save() keeps the session beside the report.
  void keep_session(bool keep);
  bool busy() const { return changed_.isActive() || previewing_.busy() || saving_.busy(); }
  /// Writes the report, PDF or HTML by the file's ending. With its session beside it, the report also says
  /// how to make it again.
  void save(const QString& file);

 signals:
  /// For the status bar.
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
