#pragma once

#include <QAction>
#include <QImage>
#include <QList>
#include <QObject>

namespace feedscope::ui {

class MainWindow;

/// Copies the window's contents to the clipboard: 3D view with its annotations, charts, or everything.
class PictureCommands : public QObject {
  Q_OBJECT

 public:
  enum class Part { scene, charts, window };

  explicit PictureCommands(MainWindow& window);

  QList<QAction*> actions() const { return actions_; }
  /// As on the screen, without the cube of views; view and charts have a line below them with program,
  /// machine, run and cycle time.
  QImage picture(Part part) const;

 private:
  QString caption() const;

  MainWindow& window_;
  QList<QAction*> actions_;
};

}  // namespace feedscope::ui
