#pragma once

#include <QDialog>
#include <QSize>
#include <QTemporaryDir>

#include "ui/charts/value_fit.h"
#include "ui/session/session.h"
#include "ui/window/file_writing.h"
#include "ui/window/film_wish.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace feedscope::ui {

class LanguageBox;
class NumberBox;
class WholeNumberBox;

/// Asks which stretch of the run is to be filmed and how, says while that is typed how long the film will be,
/// and makes it by `feedscope render --film` in a process of its own. What was chosen is remembered, but for
/// the stretch.
class FilmDialog : public QDialog {
  Q_OBJECT

 public:
  struct Subject {
    Session session;      ///< as it is shown now
    double duration = 0;  ///< of its current run [s]
    Interval shown{};     ///< what the charts show of it [s]
    QSize scene;          ///< of the 3D view, offered as a size [px]
  };

  /// `executable`: as of CommandProcess.
  FilmDialog(Subject subject, const QString& executable, QWidget* parent = nullptr);
  ~FilmDialog() override;

  FilmWish wish() const;
  /// Shows these choices.
  void choose(const FilmWish& wish);
  bool busy() const { return making_.busy(); }
  /// How long the film will be, or why there is none.
  QString length_text() const;
  /// What went wrong last, or what has been written.
  QString state() const;
  /// Beside the program: the next name that is free.
  QString proposed_file() const;
  /// A video by a file's name, a series of pictures by a pattern, as --film. done or state() follows.
  void save(const QString& file);
  /// What was begun is removed.
  void cancel();

 signals:
  /// For the status bar.
  void saved(const QString& message);

 private:
  QWidget* make_form();
  void remember() const;
  void show_stretch(const Interval& stretch);
  void follow_stretch();
  void follow();
  QString problem() const;
  void ask_and_save();
  void show_busy(bool busy);

  Subject subject_;
  QTemporaryDir folder_;
  NumberBox* from_;
  NumberBox* to_;
  NumberBox* speed_;
  WholeNumberBox* fps_;
  NumberBox* trail_;
  QCheckBox* charts_;
  QComboBox* size_;
  QComboBox* theme_;
  LanguageBox* language_;
  QComboBox* format_;
  QLabel* length_;
  StateLine* state_;
  QProgressBar* progress_;
  QPushButton* save_;
  QPushButton* cancel_;
  bool own_speed_ = false;  ///< the user chose it; otherwise it follows the stretch
  bool own_trail_ = false;  ///< the same; otherwise it follows the speed
  FileWriting making_;
};

}  // namespace feedscope::ui
