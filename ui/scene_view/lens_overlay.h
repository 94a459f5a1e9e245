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

/// The lens at the cursor over a lower corner of a 3D view, the one that leaves more to the path: the current
/// run and those that are ticked, over each other. It shows itself while there are two or more in a view that
/// is large enough; the key L says otherwise. A click enlarges it to half of the view and back.
class LensOverlay : public QWidget {
  Q_OBJECT

 public:
  /// Becomes a part of `view`. `workbench` outlives this.
  LensOverlay(Workbench& workbench, SceneView& view);

  /// Shows or hides it, whatever there is to compare.
  QAction* action() { return action_; }
  /// Whether it shows itself; else only by its action.
  void set_offered(bool offered);
  /// What is shown; null while nothing is.
  const Lens* lens() const { return isVisible() && lens_ ? &*lens_ : nullptr; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  /// The runs, the current one first.
  void list_runs();
  bool has_room() const;
  int usual_side() const;
  void place();

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
