#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "ui/identification/residual_plot.h"

namespace feedscope::ui {

/// A ResidualPlot of each recording on screen, one above the other; hidden if there are none.
class ResidualChart : public QWidget {
  Q_OBJECT

 public:
  explicit ResidualChart(QWidget* parent = nullptr);

  /// Null for none.
  void set_outcome(const std::shared_ptr<const IdentificationOutcome>& outcome, std::size_t chosen);
  const std::vector<ResidualCurves>& curves() const { return curves_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<ResidualCurves> curves_;
};

}  // namespace feedscope::ui
