#pragma once

#include <QWidget>
#include <vector>

#include "ui/charts/kinematic_chart.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

/// Distribution of the visible time over the feeds, to the right of the feed chart and along its ordinate, as
/// bars that extend to the right. Feeds above the ordinate count in its uppermost bar.
class FeedShares : public QWidget {
  Q_OBJECT

 public:
  static int usual_width() { return type_pixels(84); }  ///< [px]

  /// `chart` outlives this.
  explicit FeedShares(const KinematicChart& chart, QWidget* parent = nullptr);

  /// Achieved feeds, ascending [mm/s]: each represents the same time.
  void set_feeds(std::vector<float> feeds);
  bool is_empty() const { return feeds_.empty(); }
  /// Shares of the bars from feed 0 upwards; their sum is 1. Empty without feeds.
  std::vector<double> shares() const;
  /// "820 to 860 mm/min: 12 % of the time" for the bar at this height; empty outside.
  QString tip_at(int y) const;
  void draw(QPainter& painter) const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Edge of a bar, in the chart's unit.
  double value_of(std::size_t bar) const;
  std::size_t bar_count() const;

  const KinematicChart& chart_;
  std::vector<float> feeds_;
};

}  // namespace feedscope::ui
