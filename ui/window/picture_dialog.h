#pragma once

#include <QDialog>
#include <QSize>
#include <QTemporaryDir>
#include <QTimer>

#include "ui/report/command_process.h"
#include "ui/session/session.h"
#include "ui/window/file_writing.h"
#include "ui/window/picture_wish.h"

class QCheckBox;
class QComboBox;
class QPushButton;

namespace feedscope::ui {

class LanguageBox;
class NumberBox;
class PagePreview;
class WholeNumberBox;

/// Asks what a picture of the session is to be like, shows it as it is asked, and saves it as PNG, SVG or
/// PDF, all of that by `feedscope render` in a process of its own. What was chosen is remembered.
class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  struct Subject {
    Session session;  ///< as it is shown now
    QSize scene;      ///< of the parts of the window, offered as sizes [px]
    QSize charts;
    QSize window;
    double text_scale = 1;  ///< of text and lines in the 3D view, proposed
  };

  /// `executable`: as of CommandProcess.
  PictureDialog(Subject subject, const QString& executable, QWidget* parent = nullptr);
  ~PictureDialog() override;

  PictureWish wish() const;
  /// Shows these choices.
  void choose(const PictureWish& wish);
  PagePreview& preview() { return *preview_; }
  bool busy() const { return changed_.isActive() || previewing_.busy() || saving_.busy(); }
  /// What went wrong last, or what the preview shows.
  QString state() const;
  /// Beside the program, with its name and that of the view; the next free one.
  QString proposed_file() const;
  /// In the chosen format, whatever the ending.
  void save(const QString& file);

 signals:
  /// For the status bar.
  void saved(const QString& message);

 private:
  QWidget* make_form();
  void list_sizes();
  void follow_view();
  void ask_and_save();
  void make_preview();
  void show_preview();
  void remember() const;

  Subject subject_;
  QTemporaryDir folder_;
  QComboBox* view_;
  QComboBox* format_;
  QComboBox* size_;
  WholeNumberBox* dpi_;
  NumberBox* scale_;
  QComboBox* theme_;
  LanguageBox* language_;
  QCheckBox* transparent_;
  PagePreview* preview_;
  StateLine* state_;
  QPushButton* save_;
  QTimer changed_;
  CommandProcess previewing_;
  FileWriting saving_;
};

}  // namespace feedscope::ui
