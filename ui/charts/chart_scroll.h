#pragma once

#include <QScrollArea>

#include "ui/charts/chart_rows.h"

namespace feedscope::ui {

/// Scroll area of the charts. They fill its height, or scroll where they need more. Requests room for at most
/// three charts.
class ChartScroll : public QScrollArea {
 public:
  /// `rows` outlives this.
  explicit ChartScroll(const ChartRows& rows, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override { return rows_.least_size(*widget()); }
  /// Shows the time at each feed if there is room next to the charts.
  void fit_shares();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const ChartRows& rows_;
};

}  // namespace feedscope::ui
