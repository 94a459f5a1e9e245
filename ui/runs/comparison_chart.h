#pragma once

#include <QWidget>

#include "ui/runs/comparison_bars.h"
#include "ui/runs/comparison_layout.h"

namespace feedscope::ui {

/// Several runs of a program side by side: one bar each, as long as its cycle time, divided by limiting
/// cause; the programmed time of each machine as a line across its bars; the figures of each run next to its
/// bar.
class ComparisonChart : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonChart(QWidget* parent = nullptr);

  /// `title`: the program; `details`: further facts common to all runs, after the title.
  void set_comparison(const QString& title, const QString& details, ComparisonBars bars);
  const ComparisonBars& bars() const { return bars_; }
  /// Draws the chart at its size.
  void draw(QPainter& painter) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void draw_legend(QPainter& painter, const ComparisonLayout& layout) const;
  void draw_columns(QPainter& painter, const ComparisonLayout& layout) const;
  void draw_axis(QPainter& painter, const ComparisonLayout& layout) const;
  void draw_machines(QPainter& painter, const ComparisonLayout& layout) const;
  void draw_bars(QPainter& painter, const ComparisonLayout& layout) const;

  QString title_;
  QString details_;
  ComparisonBars bars_;
};

}  // namespace feedscope::ui
