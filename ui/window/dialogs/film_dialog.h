#pragma once

#include <QDialog>
#include <QSize>
#include <QTemporaryDir>

#include "ui/charts/value_fit.h"
#include "ui/session/session.h"
#include "ui/window/dialogs/file_writing.h"
#include "ui/window/dialogs/film_wish.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace feedscope::ui {

class LanguageBox;
class NumberBox;
class WholeNumberBox;

/// Asks for the range of the run and the options of a film, shows its length during input, and makes it by
/// `feedscope render --film` in a separate process. Choices except the range are stored.
class FilmDialog : public QDialog {
  Q_OBJECT

 public:
  struct Subject {
    Session session;      ///< in its current state
    double duration = 0;  ///< of its current run [s]
    Interval shown{};     ///< range of the charts [s]
    QSize scene;          ///< of the 3D view, an offered size [px]
  };

  /// `executable`: as of CommandProcess.
  FilmDialog(Subject subject, const QString& executable, QWidget* parent = nullptr);
  ~FilmDialog() override;

  FilmWish wish() const;
  /// Sets these choices.
  void choose(const FilmWish& wish);
  bool busy() const { return making_.busy(); }
  /// Length of the film, or the reason why there is none.
  QString length_text() const;
  /// The last error, or the written file.
  QString state() const;
  /// The next free name in the program's folder.
  QString proposed_file() const;
  /// A video by a file's name, a series of pictures by a pattern, as --film. done() or state() follows.
  void save(const QString& file);
  /// Removes the partial files.
  void cancel();

 signals:
  /// Message for the status bar.
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
  bool own_speed_ = false;  ///< chosen by the user; otherwise it follows the range
  bool own_trail_ = false;  ///< chosen by the user; otherwise it follows the speed
  FileWriting making_;
};

}  // namespace feedscope::ui
