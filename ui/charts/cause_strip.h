#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/analysis/time/cause_times.h"

namespace feedscope::ui {

QString cause_kind_name(CauseKind kind);
QString cause_name(Cause cause);

/// Limiting causes along the charts: a strip with the colour of the cause that takes most time in each pixel
/// column, and above it the causes of the visible range with their shares of its time.
///
/// Tooltips give the cause, its axes, time and share. Pressing a cause of the legend shows it alone;
/// pressing it again, or anything else, shows all.
class CauseStrip : public QWidget {
  Q_OBJECT

 public:
  explicit CauseStrip(QWidget* parent = nullptr);

  /// `columns`: over the plot's width; `times`: of all_causes() in the visible range [s].
  void set_causes(std::vector<std::optional<CauseKind>> columns, std::vector<double> times);
  /// Names the run; empty: it is the only one.
  void name_run(const QString& name);
  /// The cause shown alone.
  std::optional<CauseKind> highlighted() const { return highlighted_; }
  /// Place of a kind in the legend; empty if it does not occur or has no room.
  QRect legend_item(CauseKind kind) const;
  QRect strip() const;
  QString tip_at(const QPoint& place) const;
  void draw(QPainter& painter) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Share {
    CauseKind kind;
    double time = 0;  ///< [s]
    QString text;
    QRect place;  ///< in the legend
  };

  QString title() const;
  void lay_out();
  const Share* item_at(const QPoint& place) const;
  std::optional<CauseKind> kind_at(const QPoint& place) const;
  QString tip_of(CauseKind kind) const;
  void draw_legend(QPainter& painter) const;
  void draw_strip(QPainter& painter) const;

  std::vector<std::optional<CauseKind>> columns_;
  std::vector<double> times_;  ///< of all_causes() [s]
  double whole_ = 0;           ///< time of the visible range [s]
  std::vector<Share> shares_;  ///< the largest first
  std::size_t listed_ = 0;     ///< number of shares_ that fit in the legend
  std::optional<CauseKind> highlighted_;
  QString run_name_;
};

}  // namespace feedscope::ui
