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

/// The window in front of a class: large type, the 3D view and the charts first, the lesson as a narrow
/// column that is readable from the last row, and nothing else. Leaving it restores
/// the previous layout.
class Presentation : public QObject {
  Q_OBJECT

 public:
  /// Shown parts, and parts with their own font sizes.
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
  /// Starts the presentation; leaving it restores `usual_layout`, unless it is empty.
  void show_over(const QByteArray& usual_layout);
  /// Layout of the window outside the presentation, as QMainWindow::saveState().
  QByteArray usual_layout() const;
  /// Font size of the program text outside the presentation [px].
  int usual_program_type() const;
  /// Switch the presentation, and full screen. While it is on, a presenter's keys go to the next and the
  /// previous step of the lesson.
  QList<QAction*> actions() const { return {action_, full_screen_}; }
  QList<QAction*> step_actions() const { return {next_, previous_}; }

  /// Font size for a window, relative to the usual one: a constant share of the window, because the projector
  /// makes all windows equally large.
  static double type_scale(const QSize& window);

 signals:
  void switched(bool on);
  /// Requests the next step of the lesson, or the previous one.
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
  QSize usual_size_;  ///< of its window
  int usual_program_type_ = 0;
  std::vector<QWidget*> bars_;  ///< visible before
  QTimer resized_;
};

}  // namespace feedscope::ui
