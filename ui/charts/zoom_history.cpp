#include "ui/charts/zoom_history.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t max_views = 200;

}  // namespace

void ZoomHistory::start(const ChartView& view) {
  views_ = {view};
  at_ = 0;
}

void ZoomHistory::rest(const ChartView& view) {
  if (view == views_[at_]) {
    return;
  }
  views_.resize(at_ + 1);
  if (views_.size() == max_views) {
    views_.erase(views_.begin());
  }
  views_.push_back(view);
  at_ = views_.size() - 1;
}

}  // namespace feedscope::ui
