#pragma once

#include <QAction>
#include <QImage>
#include <QList>
#include <QObject>

namespace feedscope::ui {

class MainWindow;

/// Saves and copies what the window shows: 3D view with its annotations, charts, or all of it.
class PictureCommands : public QObject {
  Q_OBJECT

 public:
  enum class Part { scene, charts, window };

  explicit PictureCommands(MainWindow& window);

  QList<QAction*> save_actions() const { return save_; }
  QList<QAction*> copy_actions() const { return copy_; }
  /// As on the screen.
  QImage picture(Part part) const;
  /// What a picture is called unless the user says: as the program, and no file yet.
  QString proposed_file(Part part) const;
  /// PNG, SVG or PDF by the file's ending; charts as vectors where the format has them. Throws InputError
  /// where it cannot be written; nothing is left behind then.
  void save(Part part, const QString& file) const;
  void copy(Part part) const;

 signals:
  void saved(const QString& message);
  void failed(const QString& message);

 private:
  void ask_and_save(Part part);

  MainWindow& window_;
  QList<QAction*> save_;
  QList<QAction*> copy_;
};

}  // namespace feedscope::ui
