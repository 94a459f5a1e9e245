#pragma once

#include <QDialog>
#include <QSize>
#include <QTemporaryDir>
#include <QTimer>

#include "ui/report/command_process.h"
#include "ui/session/session.h"
#include "ui/window/dialogs/file_writing.h"
#include "ui/window/dialogs/picture_wish.h"

class QCheckBox;
class QComboBox;
class QPushButton;

namespace feedscope::ui {

class LanguageBox;
class NumberBox;
class PagePreview;
class WholeNumberBox;

/// Asks for the options of a picture of the session, shows a preview, and saves it as PNG, SVG or PDF, using
/// `feedscope render` in a separate process. The choices are stored.
class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  struct Subject {
    Session session;  ///< in its current state
    QSize scene;      ///< sizes of the parts of the window, offered as sizes [px]
    QSize charts;
    QSize window;
    double text_scale = 1;  ///< of text and lines in the 3D view, initial value
  };

  /// `executable`: as of CommandProcess.
  PictureDialog(Subject subject, const QString& executable, QWidget* parent = nullptr);
  ~PictureDialog() override;

  PictureWish wish() const;
  /// Sets these choices.
  void choose(const PictureWish& wish);
  PagePreview& preview() { return *preview_; }
  bool busy() const { return changed_.isActive() || previewing_.busy() || saving_.busy(); }
  /// The last error, or a description of the preview.
  QString state() const;
  /// The next free name in the program's folder, from the names of program and view.
  QString proposed_file() const;
  /// In the chosen format, whatever the ending.
  void save(const QString& file);

 signals:
  /// Message for the status bar.
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
