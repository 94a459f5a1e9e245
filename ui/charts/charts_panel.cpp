#include "ui/charts/charts_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace feedscope::ui {

ChartsPanel::ChartsPanel(Cursor& cursor, QWidget* parent)
    : QWidget(parent),
      cursor_(cursor),
      range_(this),
      causes_(new CauseStrip(this)),
      abscissa_(new QComboBox(this)),
      show_all_(new QToolButton(this)) {
  abscissa_->addItems({tr("over time"), tr("over path length")});
  abscissa_->setToolTip(tr("What runs along the charts"));
  connect(abscissa_, &QComboBox::currentIndexChanged, this, &ChartsPanel::choose_abscissa);
  show_all_->setText(tr("Show all"));
  show_all_->setToolTip(tr("Show the whole run (double click in a chart)"));
  connect(show_all_, &QToolButton::clicked, this, &ChartsPanel::fit);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  const std::array<ChartSpec, chart_count> specs = kinematic_chart_specs();
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const bool last = i + 1 == specs.size();
    layout->addLayout(add_header(i, specs[i]));
    charts_[i] = new KinematicChart(specs[i], range_, last, this);
    layout->addWidget(charts_[i], last ? 4 : 3);
    if (i == 0) {
      layout->addWidget(causes_);
    }
    connect(charts_[i], &KinematicChart::position_clicked, this,
            [this](double position) { cursor_.set_time(range_.time_at(position)); });
    connect(charts_[i], &KinematicChart::plot_resized, &refresh_, qOverload<>(&QTimer::start));
    connect(charts_[i], &KinematicChart::fit_requested, this, &ChartsPanel::fit);
  }
  charts_.back()->set_abscissa_title(tr("Time [s]"));

  refresh_.setSingleShot(true);
  refresh_.setInterval(0);
  connect(&refresh_, &QTimer::timeout, this, &ChartsPanel::refresh);
  connect(&range_, &ViewRange::changed, &refresh_, qOverload<>(&QTimer::start));
  connect(&cursor_, &Cursor::changed, this, &ChartsPanel::show_cursor);
}

QLayout* ChartsPanel::add_header(std::size_t i, const ChartSpec& spec) {
  headers_[i] = new ChartHeader(spec, this);
  connect(headers_[i], &ChartHeader::curve_clicked, this,
          [this, i](std::size_t curve) { show_curve(i, curve, !charts_[i]->curve_shown(curve)); });
  connect(headers_[i], &ChartHeader::curve_alone_clicked, this,
          [this, i](std::size_t curve) { show_alone(i, curve); });
  auto* head = new QHBoxLayout;
  head->setContentsMargins(0, 0, 8, 0);
  head->addWidget(headers_[i]);
  if (i == 0) {
    head->addWidget(abscissa_);
    head->addWidget(show_all_);
  }
  return head;
}

void ChartsPanel::show_curve(std::size_t chart, std::size_t curve, bool shown) {
  charts_[chart]->show_curve(curve, shown);
  headers_[chart]->show_curve(curve, shown);
}

/// The second time all.
void ChartsPanel::show_alone(std::size_t chart, std::size_t curve) {
  const std::size_t count = charts_[chart]->spec().curves.size();
  bool alone = true;
  for (std::size_t i = 0; i < count; ++i) {
    alone = alone && (i == curve) == charts_[chart]->curve_shown(i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    show_curve(chart, i, alone || i == curve);
  }
}

void ChartsPanel::fit() {
  for (KinematicChart* chart : charts_) {
    chart->choose_values({});
  }
  range_.fit();
}

void ChartsPanel::set_run(std::shared_ptr<const Trajectory> trajectory,
                          std::shared_ptr<const Envelope> envelope, bool keep_range) {
  envelope_ = std::move(envelope);
  range_.set_trajectory(std::move(trajectory), keep_range);
}

void ChartsPanel::set_limits(const std::array<AxisLimits, 3>& limits) {
  const std::array<double AxisLimits::*, 3> kinds{&AxisLimits::velocity, &AxisLimits::acceleration,
                                                  &AxisLimits::jerk};
  for (std::size_t k = 0; k < charts_.size(); ++k) {
    std::vector<LimitLine> lines;
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const double value = charts_[k]->spec().convert(limits[i].*kinds[k]);
      const QString axis(QChar(axis_names[i]));
      if (!lines.empty() && lines.back().value == value) {
        lines.back().label += ' ' + axis;
        lines.back().axis.reset();
      } else {
        lines.push_back({value, axis, i});
      }
    }
    for (LimitLine& line : lines) {
      line.label = tr("limit of %1").arg(line.label);
    }
    charts_[k]->set_limits(lines);
  }
  refresh_.start();
}

void ChartsPanel::hide_controls() {
  abscissa_->hide();
  show_all_->hide();
}

void ChartsPanel::refresh() {
  refresh_.stop();
  std::vector<Band> bands;
  if (envelope_ != nullptr) {
    const std::vector<double> times = range_.column_times(charts_.front()->column_count());
    bands = envelope_->columns(times);
    causes_->set_causes(envelope_->causes().dominating(times),
                        envelope_->causes().between(times.front(), times.back()));
  } else {
    causes_->set_causes({}, {});
  }
  for (KinematicChart* chart : charts_) {
    chart->show_bands(bands);
  }
  show_cursor();
}

void ChartsPanel::show_cursor() {
  const bool shown = envelope_ != nullptr && cursor_.valid();
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    charts_[i]->set_cursors(shown ? std::optional(range_.position_of(cursor_.state())) : std::nullopt, {});
    headers_[i]->set_state(shown ? std::optional(cursor_.state()) : std::nullopt);
  }
}

void ChartsPanel::choose_abscissa(int index) {
  range_.set_abscissa(index == 0 ? Abscissa::time : Abscissa::path_length);
  charts_.back()->set_abscissa_title(index == 0 ? tr("Time [s]") : tr("Path length [mm]"));
}

}  // namespace feedscope::ui
