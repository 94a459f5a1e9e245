#pragma once

#include <QAction>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/scene_view/scene_view.h"
#include "ui/shared/lens_picture.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

/// The lens at the cursor over the bottom right corner of a 3D view: the current run and the ticked ones,
/// over each other. It appears if there are two or more runs and the view is large enough, or by the key L. A
/// click enlarges it to half of the view and back.
class LensOverlay : public QWidget {
  Q_OBJECT

 public:
  /// Becomes a part of `view`. `workbench` outlives this.
  LensOverlay(Workbench& workbench, SceneView& view);

  /// Shows or hides it, even without runs to compare.
  QAction* action() { return action_; }
  /// Whether it appears by itself; else only by its action.
  void set_offered(bool offered);
  /// The shown lens; null if hidden.
  const Lens* lens() const { return isVisible() && lens_ ? &*lens_ : nullptr; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  /// Lists the runs, the current one first.
  void list_runs();
  bool has_room() const;
  void place();
  void leave_free(bool shown);

  Workbench& workbench_;
  SceneView& view_;
  QAction* action_;
  std::optional<bool> wanted_;  ///< by the user
  bool offered_ = true;
  bool large_ = false;
  std::vector<std::shared_ptr<const ShownRun>> runs_;
  std::vector<LensLook> looks_;
  std::optional<Lens> lens_;
};

}  // namespace feedscope::ui
