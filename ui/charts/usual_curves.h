#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/analysis/envelope/usual_motion.h"
#include "ui/charts/chart_columns.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// Usual range of the motion along the visible range, if that is so long that the extremes in the pixel
/// columns are not informative. Computed on another thread, or at once for pictures.
class UsualCurves : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Keeps the previous result until the new one is ready. `rapids`: whether they count.
  void follow(const ChartColumns& columns, bool rapids);
  /// For pictures, which are drawn at once.
  void find_at_once() { at_once_ = true; }
  bool busy() const { return job_.busy(); }

  /// Columns in a stretch; the last stretch may be shorter.
  static constexpr std::size_t columns_a_stretch = 12;
  /// Empty if the visible range is short.
  const UsualMotion& found() const { return found_; }

 signals:
  void changed();

 private:
  void set(UsualMotion found);

  UsualMotion found_;
  std::shared_ptr<const Trajectory> asked_;  ///< of the last request
  std::vector<double> asked_times_;
  bool asked_rapids_ = true;
  Job<UsualMotion> job_;
  bool at_once_ = false;
};

}  // namespace feedscope::ui
