#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/charts/chart_spec.h"
#include "ui/charts/limit_line.h"

namespace feedscope::ui {

/// Another run in a legend.
struct LegendEntry {
  QString name;
  QColor color;
  bool dashed = false;
  std::optional<double> value;  ///< at the cursor, in the chart's unit
};

/// The label in the corner of a plot: quantity with unit, and the shown curves in their colours. Under the
/// pointer, or after list_all(), it also lists hidden curves, other runs, limits and notes. A click on a
/// curve requests to show or hide it, with Ctrl to show it alone; the tooltip has the values at the cursor.
class ChartHeader : public QWidget {
  Q_OBJECT

 public:
  explicit ChartHeader(ChartSpec spec, QWidget* parent = nullptr);

  /// Fits the label into the plot, in coordinates of its parent [px]: it takes the width that it needs.
  void fit_in(const QRect& room);
  /// Shows the values at the cursor; none: no values.
  void show_values(const std::optional<Instant>& instant);
  void show_curve(std::size_t curve, bool shown);
  /// The curves that the run has; the others are not listed.
  void set_available(std::vector<bool> available);
  /// Names the run of the curves in the title; empty: it is the only one.
  void name_run(const QString& name);
  void set_runs(std::vector<LegendEntry> runs);
  const std::vector<LegendEntry>& runs() const { return runs_; }
  /// The limits in the plot, and notes on values that it omits or adds.
  void set_notes(std::vector<LimitLine> limits, QStringList notes);
  const QStringList& notes() const { return notes_; }
  /// Lists everything, as for a picture without a pointer.
  void list_all(bool all);
  /// Place of a curve in the label; null if it is not listed.
  QRect item(std::size_t curve) const;
  QString tip_at(const QPoint& place) const;
  void draw(QPainter& painter) const;

  QSize sizeHint() const override;

 signals:
  void curve_clicked(std::size_t curve);
  void curve_alone_clicked(std::size_t curve);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  enum class Kind { curve, run, limit, note };
  struct Item {
    Kind kind;
    std::size_t index;
    QRect place;
  };

  /// Items in the order of their importance, as many as fit in `width`.
  std::vector<Item> items(int width) const;
  QString title() const;
  int title_width() const;
  int width_of(Kind kind, std::size_t index) const;
  const QString& text_of(Kind kind, std::size_t index) const;
  QString number(double value) const;
  void relist();
  std::optional<std::size_t> curve_at(const QPoint& place) const;
  void draw_item(QPainter& painter, const Item& item) const;

  ChartSpec spec_;
  QString run_name_;
  std::vector<bool> shown_;
  std::vector<bool> available_;
  std::vector<LegendEntry> runs_;
  std::vector<LimitLine> limits_;
  QStringList notes_;
  std::vector<std::optional<double>> values_;  ///< one for each curve, in the chart's unit
  QRect room_;
  bool all_ = false;
};

}  // namespace feedscope::ui
