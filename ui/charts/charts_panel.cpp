#include "ui/charts/charts_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/units.h"

namespace feedscope::ui {

namespace {

// Okabe and Ito's palette: told apart with every kind of colour vision.
const QColor path_color(0x1a, 0x1a, 0x1a);
const QColor programmed_color(0xe6, 0x9f, 0x00);
const QColor shared_limit_color(0x66, 0x66, 0x66);
constexpr std::array<QRgb, 3> axis_rgb{0xd55e00, 0x009e73, 0x0072b2};

constexpr double path_width = 1.8;
constexpr double axis_width = 1.1;

/// `first` and the two channels after it are those of X, Y and Z.
void add_axes(ChartSpec& spec, Channel first) {
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    spec.curves.push_back({static_cast<Channel>(static_cast<std::size_t>(first) + i),
                           QString(QChar(axis_names[i])), QColor(axis_rgb[i]), axis_width});
  }
}

std::array<ChartSpec, 3> chart_specs() {
  const QString tangential = ChartsPanel::tr("tangential");
  ChartSpec feed{
      ChartsPanel::tr("Feed"),
      ChartsPanel::tr("mm/min"),
      {{Channel::feed, ChartsPanel::tr("achieved"), path_color, path_width},
       {Channel::programmed_feed, ChartsPanel::tr("programmed"), programmed_color, path_width, true}},
      units::to_mm_min,
      0};
  add_axes(feed, Channel::velocity_x);
  ChartSpec acceleration{ChartsPanel::tr("Acceleration"),
                         ChartsPanel::tr("m/s²"),
                         {{Channel::tangential_acceleration, tangential, path_color, path_width}},
                         units::to_m,
                         2};
  add_axes(acceleration, Channel::acceleration_x);
  ChartSpec jerk{ChartsPanel::tr("Jerk"),
                 ChartsPanel::tr("m/s³"),
                 {{Channel::tangential_jerk, tangential, path_color, path_width, true}},
                 units::to_m,
                 1};
  add_axes(jerk, Channel::jerk_x);
  return {feed, acceleration, jerk};
}

}  // namespace

ChartsPanel::ChartsPanel(Cursor& cursor, QWidget* parent)
    : QWidget(parent),
      cursor_(cursor),
      range_(this),
      abscissa_(new QComboBox(this)),
      show_all_(new QToolButton(this)) {
  abscissa_->addItems({tr("over time"), tr("over path length")});
  abscissa_->setToolTip(tr("What runs along the charts"));
  connect(abscissa_, &QComboBox::currentIndexChanged, this, &ChartsPanel::choose_abscissa);
  show_all_->setText(tr("Show all"));
  show_all_->setToolTip(tr("Show the whole run (double click in a chart)"));
  connect(show_all_, &QToolButton::clicked, &range_, &ViewRange::fit);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  const std::array<ChartSpec, 3> specs = chart_specs();
  for (std::size_t i = 0; i < specs.size(); ++i) {
    headers_[i] = new ChartHeader(specs[i], this);
    const bool last = i + 1 == specs.size();
    charts_[i] = new KinematicChart(specs[i], range_, last, this);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(0, 0, 8, 0);
    head->addWidget(headers_[i]);
    if (i == 0) {
      head->addWidget(abscissa_);
      head->addWidget(show_all_);
    }
    layout->addLayout(head);
    layout->addWidget(charts_[i], last ? 4 : 3);
    connect(charts_[i], &KinematicChart::position_clicked, this,
            [this](double position) { cursor_.set_time(range_.time_at(position)); });
    connect(charts_[i], &KinematicChart::plot_resized, &refresh_, qOverload<>(&QTimer::start));
  }
  charts_.back()->set_abscissa_title(tr("Time [s]"));

  refresh_.setSingleShot(true);
  refresh_.setInterval(0);
  connect(&refresh_, &QTimer::timeout, this, &ChartsPanel::refresh);
  connect(&range_, &ViewRange::changed, &refresh_, qOverload<>(&QTimer::start));
  connect(&cursor_, &Cursor::changed, this, &ChartsPanel::show_cursor);
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
        lines.back().color = shared_limit_color;
      } else {
        lines.push_back({value, axis, QColor(axis_rgb[i])});
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
    bands = envelope_->columns(range_.column_times(charts_.front()->column_count()));
  }
  for (KinematicChart* chart : charts_) {
    chart->show_bands(bands);
  }
  show_cursor();
}

void ChartsPanel::show_cursor() {
  const bool shown = envelope_ != nullptr && cursor_.valid();
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    charts_[i]->set_cursor(shown ? std::optional(range_.position_of(cursor_.state())) : std::nullopt);
    headers_[i]->set_state(shown ? std::optional(cursor_.state()) : std::nullopt);
  }
}

void ChartsPanel::choose_abscissa(int index) {
  range_.set_abscissa(index == 0 ? Abscissa::time : Abscissa::path_length);
  charts_.back()->set_abscissa_title(index == 0 ? tr("Time [s]") : tr("Path length [mm]"));
}

}  // namespace feedscope::ui
