#pragma once

#include <QScrollArea>

#include "ui/charts/chart_rows.h"

namespace feedscope::ui {

/// Holds the charts: as high as it is, or higher where they need more, and then to be scrolled. It asks for
/// room for three charts at most.
class ChartScroll : public QScrollArea {
 public:
  /// `rows` outlives this.
  explicit ChartScroll(const ChartRows& rows, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override { return rows_.least_size(*widget()); }
  /// Shows the time at each feed where there is room beside the charts.
  void fit_shares();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const ChartRows& rows_;
};

}  // namespace feedscope::ui
