#pragma once

#include <QWidget>

#include "ui/scene_view/scene_view.h"

class QLabel;

namespace feedscope::ui {

/// The name of a run after a square of its colour, as HTML.
QString run_mark(const QString& name, const QColor& colour);

/// The line between two halves of a view, with a grip to take it by. Dragged with the mouse; Left, Right,
/// Home and End move it while it has the focus.
class SplitHandle : public QWidget {
  Q_OBJECT

 public:
  explicit SplitHandle(QWidget* parent);

 signals:
  /// To `x` of the parent.
  void dragged(int x);
  /// By so many steps, to the left below 0; far beyond the ends: to an end.
  void stepped(int steps);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  int grabbed_at_ = 0;  ///< from the middle of the handle
};

/// Lays one 3D view over the right part of another one that is as large: pixels of both are at the same
/// place. A name stands at the top on either side of the line.
class SplitOverlay : public QObject {
  Q_OBJECT

 public:
  /// `right` becomes a part of `left` while this lives and is deleted with this; so is `right_name`.
  SplitOverlay(SceneView& left, SceneView* right, QWidget* right_name, double share);
  ~SplitOverlay() override;

  /// Of the width that is on the left, 0 to 1, clamped.
  void set_share(double share);
  double share() const { return share_; }
  void step(int steps);
  SplitHandle& handle() { return *handle_; }
  /// The name over the left half, as run_mark() makes it.
  void set_left_name(const QString& mark);
  /// What else is said of the halves, below the names.
  void set_notes(const QString& left, const QString& right);

 signals:
  void share_changed(double share);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  SceneView& left_;
  SceneView* right_;
  QWidget* pane_;  ///< clips the right view
  SplitHandle* handle_;
  QLabel* left_name_;
  QWidget* right_name_;
  QLabel* left_note_;
  QLabel* right_note_;
  double share_;
};

}  // namespace feedscope::ui
