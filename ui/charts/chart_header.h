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
  std::optional<double> value;  ///< where the cursor is, in the chart's unit
};

/// The lines above a chart: quantity with unit, and each curve with its value at the cursor, in as many lines
/// as they need; other runs below, if there are any, in two lines at most. A click on a curve asks to show or
/// hide it, with Ctrl to show it alone.
class ChartHeader : public QWidget {
  Q_OBJECT

 public:
  explicit ChartHeader(ChartSpec spec, QWidget* parent = nullptr);

  /// Of the cursor's place; none: no values.
  void show_values(const std::optional<Instant>& instant);
  void show_curve(std::size_t curve, bool shown);
  /// Which curves the run has; the others are not listed.
  void set_available(std::vector<bool> available);
  void set_runs(std::vector<LegendEntry> runs);
  const std::vector<LegendEntry>& runs() const { return runs_; }
  /// The limits that the plot shows, and notes on what it leaves out or adds: behind the curves. A line that
  /// they once needed stays at this width, so that the plot below does not change its height while it is
  /// read.
  void set_notes(std::vector<LimitLine> limits, QStringList notes);
  const QStringList& notes() const { return notes_; }
  /// Where each limit stands, then each note.
  std::vector<QRect> note_places() const { return lay_out(width()).notes; }
  /// Where a curve stands, value included; null of one that is not available.
  QRect item(std::size_t curve) const;
  QString tip_at(const QPoint& place) const;
  void draw(QPainter& painter) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  int heightForWidth(int width) const override;

 signals:
  void curve_clicked(std::size_t curve);
  void curve_alone_clicked(std::size_t curve);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  struct Layout {
    std::vector<QRect> curves;
    std::vector<QRect> notes;  ///< of the limits, then of the notes
    std::vector<QRect> runs;   ///< those that there is room for
    int curves_height = 0;
    int height = 0;
  };

  Layout lay_out(int width) const;
  void add_runs(Layout& layout, int width) const;
  int row_height() const;
  int value_width() const;
  int item_width(const QString& name) const;
  int run_width(const LegendEntry& run) const;
  QString unit_text() const;
  QString number(double value) const;
  std::optional<std::size_t> curve_at(const QPoint& place) const;
  void draw_title(QPainter& painter) const;
  void draw_curve(QPainter& painter, std::size_t curve, const QRect& place) const;
  void draw_notes(QPainter& painter, const std::vector<QRect>& places) const;
  void draw_runs(QPainter& painter, const Layout& layout) const;

  ChartSpec spec_;
  std::vector<bool> shown_;
  std::vector<bool> available_;
  std::vector<LegendEntry> runs_;
  std::vector<LimitLine> limits_;
  QStringList notes_;
  int kept_height_ = 0;     ///< of curves and notes [px], see set_notes()
  bool run_below_ = false;  ///< there was no room for the only run behind them: it keeps its line
  std::vector<std::optional<double>> values_;  ///< a curve each, in the chart's unit
};

}  // namespace feedscope::ui
