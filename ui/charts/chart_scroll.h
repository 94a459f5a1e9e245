#pragma once

#include <QScrollArea>

#include "ui/charts/chart_rows.h"

namespace feedscope::ui {

/// Holds the charts: as high as it is, or higher where they need more, and then to be scrolled. It asks for
/// room for four charts at most.
class ChartScroll : public QScrollArea {
 public:
  /// `rows` outlives this.
  explicit ChartScroll(const ChartRows& rows, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override { return rows_.least_size(*widget()); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const ChartRows& rows_;
};

}  // namespace feedscope::ui
