#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/charts/kinematic_chart.h"

namespace feedscope::ui {

/// The line above a chart: quantity with unit, and each curve with its value at the cursor.
class ChartHeader : public QWidget {
  Q_OBJECT

 public:
  explicit ChartHeader(ChartSpec spec, QWidget* parent = nullptr);

  void set_state(const std::optional<State>& state);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ChartSpec spec_;
  std::optional<State> state_;
};

}  // namespace feedscope::ui
