#pragma once

#include <QScrollArea>

#include "ui/workbench/panel.h"

namespace feedscope::ui {

/// A panel in its dock: as large as the dock, or as small as possible and scrolled. Requests the room that
/// the other parts of the window can spare, so that no panel makes the window larger than a small screen.
class PanelScroll : public QScrollArea {
 public:
  /// Takes ownership of `panel`.
  explicit PanelScroll(ui::Panel& panel, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return panel_.sizeHint(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  ui::Panel& panel_;  ///< QFrame has a member named Panel
};

}  // namespace feedscope::ui
