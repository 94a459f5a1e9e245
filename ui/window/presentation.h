#pragma once

#include <QByteArray>
#include <QMainWindow>
#include <QSize>
#include <QTimer>
#include <vector>

class QAction;
class QDockWidget;

namespace feedscope::ui {

class DockSizes;
class ProgramView;
class SceneView;

/// The window before a class: large type, the 3D view and the charts first, the lesson as a narrow column
/// that can be read from the last row, and nothing else. Leaving it brings back
/// the layout as it was.
class Presentation : public QObject {
  Q_OBJECT

 public:
  /// What is shown, and what has sizes of its own.
  struct Parts {
    QDockWidget& lesson;
    QDockWidget& charts;
    SceneView& scene;
    ProgramView& program;
  };
  /// All outlive this.
  Presentation(QMainWindow& window, DockSizes& sizes, const Parts& parts);
  ~Presentation() override;

  bool on() const { return on_; }
  void set_on(bool on);
  /// Presents; `usual_layout` is what leaving brings back, unless it is empty.
  void show_over(const QByteArray& usual_layout);
  /// Layout of the window when it does not present, as QMainWindow::saveState().
  QByteArray usual_layout() const;
  /// Type of the program text when the window does not present [px].
  int usual_program_type() const;
  /// Switches it, and the whole screen; the next and the previous step of the lesson, by the keys of a
  /// presenter while it is on.
  QList<QAction*> actions() const { return {action_, full_screen_}; }
  QList<QAction*> step_actions() const { return {next_, previous_}; }

  /// Size of type for a window, against the usual one: the same share of the window, whatever its size. The
  /// projector makes all of them equally large.
  static double type_scale(const QSize& window);

 signals:
  void switched(bool on);
  /// The next step of the lesson, or the previous one.
  void step_wanted(bool forward);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_actions();
  void enter();
  void leave();
  void settle(const QSize& size);
  void follow_size();
  void share_out();

  QMainWindow& window_;
  DockSizes& sizes_;
  Parts parts_;
  QAction* action_ = nullptr;
  QAction* full_screen_ = nullptr;
  QAction* next_ = nullptr;
  QAction* previous_ = nullptr;
  bool on_ = false;
  QByteArray usual_layout_;
  QSize usual_size_;  ///< of the window that it is of
  int usual_program_type_ = 0;
  std::vector<QWidget*> bars_;  ///< that were there before
  QTimer resized_;
};

}  // namespace feedscope::ui
