#include "ui/charts/charts_panel.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/charts/measurement.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/theme/type_size.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {
constexpr auto rest_after = std::chrono::milliseconds(500);
/// Whether the model applies the jerk limits of the axes anywhere on the path.
bool keeps_axis_jerk(const Setup& setup) {
  const Guarantees promised = setup.model->guarantees(setup.settings);
  const auto keeps = [](const KeptLimits& limits) { return limits.jerk.of != KeptLimit::Of::nothing; };
  return promised.limits_jerk && (keeps(promised.lines) || keeps(promised.arcs) || keeps(promised.blends));
}

}  // namespace

ChartsPanel::ChartsPanel(Cursor& cursor, ViewRange& range, QWidget* parent)
    : Panel({QStringLiteral("charts"), tr("Charts"), Qt::BottomDockWidgetArea}, parent),
      cursor_(cursor),
      range_(range),
      scroll_(new ChartScroll(rows_, this)),
      causes_(new CauseStrip(this)),
      readout_(new QLabel(this)),
      more_(new QToolButton(this)) {
  readout_->setContentsMargins(6, 1, 6, 1);
  readout_->setAttribute(Qt::WA_TransparentForMouseEvents);
  readout_->setAutoFillBackground(true);
  readout_->setBackgroundRole(QPalette::Text);
  readout_->setForegroundRole(QPalette::Base);
  set_type_pixels(*readout_, 11);
  readout_->hide();

  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll_);
  layout_ = new QVBoxLayout(scroll_->widget());
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(0);
  readout_->setParent(scroll_->widget());
  more_->setParent(scroll_->widget());
  const std::array<ChartSpec, chart_count> specs = kinematic_chart_specs();
  for (std::size_t i = 0; i < specs.size(); ++i) {
    rows_.charts[i] = new KinematicChart(specs[i], range_, this);
    rows_.hidden[i] = specs[i].on_demand;
    layout_->addWidget(rows_.charts[i], ChartRows::stretch);
    add_header(i, specs[i]);
    connect_chart(*rows_.charts[i]);
    if (i == 0) {
      layout_->addWidget(causes_);
      rows_.lost = new LostTimeChart(range_, this);
      rows_.shares = new FeedShares(*rows_.charts[i], scroll_->widget());
      layout_->addWidget(rows_.lost);
    }
  }
  show_charts_of_run();
  commands_ = new ChartCommands(*this);
  connect(commands_, &ChartCommands::exported, this, &ChartsPanel::exported);
  connect(commands_, &ChartCommands::failed, this, &ChartsPanel::failed);
  more_->setText(QStringLiteral("☰"));
  more_->setToolTip(tr("Chart commands"));
  more_->setMenu(&commands_->menu());
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setAutoRaise(true);
  more_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
  more_->raise();

  refresh_.setSingleShot(true);
  connect(&refresh_, &QTimer::timeout, this, &ChartsPanel::refresh);
  rest_.setSingleShot(true);
  rest_.setInterval(rest_after);
  connect(&rest_, &QTimer::timeout, this, &ChartsPanel::rest);
  connect(&range_, &ViewRange::changed, &refresh_, qOverload<>(&QTimer::start));
  connect(&range_, &ViewRange::rapids_shown_changed, &refresh_, qOverload<>(&QTimer::start));
  connect(&usual_, &UsualCurves::changed, this, [this] {
    rows_.show_usual(usual_.found());
    scroll_->fit_shares();
  });
  connect(&range_, &ViewRange::changed, this, &ChartsPanel::begin_rest);
  connect(&cursor_, &Cursor::changed, this, &ChartsPanel::show_cursor);
}

void ChartsPanel::add_header(std::size_t i, const ChartSpec& spec) {
  rows_.headers[i] = new ChartHeader(spec, rows_.charts[i]);
  connect(rows_.headers[i], &ChartHeader::curve_clicked, this,
          [this, i](std::size_t curve) { show_curve(i, curve, !rows_.charts[i]->curve_shown(curve)); });
  connect(rows_.headers[i], &ChartHeader::curve_alone_clicked, this,
          [this, i](std::size_t curve) { show_alone(i, curve); });
}

void ChartsPanel::connect_chart(KinematicChart& chart) {
  new FocusOutline(chart);
  connect(&chart, &KinematicChart::position_clicked, this, [this](double position) {
    cursor_.set_time(range_.time_at(position));
    emit time_chosen();
  });
  connect(&chart, &KinematicChart::second_position_clicked, this,
          [this](double position) { set_second_cursor(range_.time_at(position)); });
  connect(&chart, &KinematicChart::plot_resized, &refresh_, qOverload<>(&QTimer::start));
  connect(&chart, &KinematicChart::plot_resized, this, &ChartsPanel::place_overlays);
  connect(&chart, &KinematicChart::values_chosen, this, &ChartsPanel::begin_rest);
  connect(&chart, &KinematicChart::values_chosen, this, [this] { rows_.show_notes(); });
  connect(&chart, &KinematicChart::fit_requested, this, &ChartsPanel::fit);
  connect(&chart, &KinematicChart::menu_requested, this,
          [this](const QPoint& global) { commands_->menu().popup(global); });
  chart.installEventFilter(this);
}

/// Places the labels, the menu button and the line of values over the plots.
void ChartsPanel::place_overlays() {
  rows_.place_shares();
  const KinematicChart& first = *rows_.charts.front();
  const QSize button = more_->sizeHint();
  more_->setGeometry(first.geometry().right() - button.width() - 2, first.geometry().top() + 2,
                     button.width(), QFontMetrics(font()).height() + 4);
  for (std::size_t i = 0; i < rows_.charts.size(); ++i) {
    QRect room = rows_.charts[i]->plot().toAlignedRect().adjusted(2, 0, -2, 0);
    room.setRight(room.right() - (i == 0 ? button.width() : 0));
    rows_.headers[i]->fit_in(room);
  }
  place_readout();
}

/// Places the values next to the cursor in the first plot.
void ChartsPanel::place_readout() {
  const KinematicChart& first = *rows_.charts.front();
  const QRect plot = first.plot().toAlignedRect().translated(first.geometry().topLeft());
  const QSize size = readout_->sizeHint();
  constexpr int beside = 8;  // [px]
  const int cursor = first.cursor()
                         ? first.geometry().left() + static_cast<int>(first.pixel_of(*first.cursor()))
                         : plot.left();
  const int left =
      std::clamp(cursor + beside, plot.left(), std::max(plot.left(), plot.right() - size.width()));
  readout_->setGeometry(left, plot.bottom() - size.height() - 1, size.width(), size.height());
  readout_->raise();
}

void ChartsPanel::set_run(std::shared_ptr<const Trajectory> trajectory,
                          std::shared_ptr<const Envelope> envelope, bool keep_range,
                          const RunSources& sources) {
  if (!keep_range) {
    held_.reset();
  } else if (trajectory == nullptr && trajectory_ != nullptr) {
    hold_range();
  }
  if (second_.has_value() && trajectory != nullptr && trajectory_ != nullptr && keep_range) {
    second_ = trajectory->state_at_path(trajectory_->state(*second_).path_length).time;
  } else {
    second_.reset();
  }
  trajectory_ = trajectory;
  columns_.set_run(trajectory, std::move(envelope));
  sources_ = sources;
  rows_.set_bounds(sources_.load.get());
  rows_.set_sources(sources_);
  show_charts_of_run();
  overlays_.clear();
  if (!keep_range) {
    rows_.choose_values({});
    range_.set_end_beside(0);
  }
  range_.set_trajectory(std::move(trajectory), keep_range);
  if (!keep_range) {
    history_.start(view());
  }
  rest();
  if (trajectory_ != nullptr && held_.has_value()) {
    show_held_range();
  }
  if (trajectory_ != nullptr && awaiting_run_.has_value()) {
    show_range(ChartsState(*awaiting_run_));
  }
}

void ChartsPanel::follow(Workbench& workbench) {
  RunList& runs = workbench.runs();
  const TraceList& traces = workbench.traces();
  const auto show_others = [this, &runs, &traces] {
    std::vector<RunOverlay> others = other_runs(runs);
    name_run(others.empty() ? QString() : run_letter(runs.current()));
    set_overlays(std::move(others), shown_traces(traces));
  };
  connect(&workbench, &Workbench::drawn_changed, this, [this, &workbench] { show_run_of(workbench); });
  connect(&runs, &RunList::list_changed, this, show_others);
  connect(&runs, &RunList::current_changed, this, show_others);
  connect(&runs, &RunList::item_changed, this, show_others);
  connect(&runs, &RunList::result_changed, this, show_others);
  connect(&traces, &TraceList::list_changed, this, show_others);
  connect(&traces, &TraceList::changed, this, show_others);
  connect(&workbench, &Workbench::program_changed, this, [this, &workbench] {
    if (workbench.program() != nullptr && std::exchange(shown_file_, workbench.file()) != workbench.file()) {
      show_usual_curves();
    }
  });
  show_run_of(workbench);
  show_others();
}

void ChartsPanel::show_run_of(Workbench& workbench) {
  const auto shown = workbench.drawn();
  const SetupEdit& setup = workbench.setup();
  set_limits(setup.setup());
  const bool is_shown = shown != nullptr && shown->run.trajectory == trajectory_ &&
                        shown->envelope.get() == columns_.envelope();
  if (!is_shown) {
    set_run(shown == nullptr ? nullptr : shown->run.trajectory, shown == nullptr ? nullptr : shown->envelope,
            workbench.program() != nullptr, shown == nullptr ? RunSources() : shown->run.sources);
  }
  if (const auto period = setup.interpolation_period()) {
    set_sample_time(*period);
  }
}

void ChartsPanel::show_charts_of_run() {
  const bool time = range_.abscissa() == Abscissa::time;
  rows_.show(columns_.envelope(), time ? tr("Time [s]") : with_unit_of(tr("Path length"), Dimension::length),
             *layout_);
  scroll_->updateGeometry();
}

void ChartsPanel::hold_range() {
  held_ = {state(), std::nullopt};
  if (second_.has_value()) {
    held_->second_place = trajectory_->state(*second_).path_length;
  }
}

void ChartsPanel::show_held_range() {
  Held held = *std::exchange(held_, std::nullopt);
  if (held.second_place.has_value()) {
    held.state.second_cursor = trajectory_->state_at_path(*held.second_place).time;
  }
  show_range(held.state);
}

void ChartsPanel::set_overlays(std::vector<RunOverlay> overlays, std::vector<TraceOverlay> traces) {
  overlays_.set_runs(std::move(overlays));
  overlays_.set_traces(std::move(traces));
  refresh_.start();
}

void ChartsPanel::name_run(const QString& name) {
  for (ChartHeader* header : rows_.headers) {
    header->name_run(name);
  }
  causes_->name_run(name);
}

void ChartsPanel::set_overlay_curve(std::size_t chart, std::optional<std::size_t> curve) {
  overlays_.choose(chart, curve);
  refresh_.start();
}

void ChartsPanel::set_limits(const Setup& setup) {
  rows_.set_limits(setup.machine.axes, keeps_axis_jerk(setup));
  rows_.set_rotary_limits(setup.machine.kinematics);
  refresh_.start();
}

void ChartsPanel::hide_controls() {
  scroll_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  more_->hide();
  for (ChartHeader* header : rows_.headers) {
    header->list_all(true);
  }
  rows_.lost->switch_off();
  usual_.find_at_once();
}

void ChartsPanel::show_curve(std::size_t chart, std::size_t curve, bool shown) {
  rows_.charts[chart]->show_curve(curve, shown);
  rows_.headers[chart]->show_curve(curve, shown);
  commands_->set_curve_shown(chart, curve, shown);
  rows_.show_notes();
}

void ChartsPanel::show_usual_curves() {
  for (std::size_t i = 0; i < rows_.charts.size(); ++i) {
    const std::vector<CurveSpec>& curves = rows_.charts[i]->spec().curves;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      show_curve(i, k, !curves[k].on_demand);
    }
  }
}

void ChartsPanel::show_chart(std::size_t chart, bool shown) {
  std::size_t others = 0;
  for (std::size_t i = 0; i < rows_.charts.size(); ++i) {
    others += i != chart && !rows_.hidden[i] && rows_.has(columns_.envelope(), i) ? 1 : 0;
  }
  rows_.hidden[chart] = !shown && others > 0;
  commands_->set_chart_shown(chart, !rows_.hidden[chart]);
  show_charts_of_run();
  refresh_.start();
}

/// Shows the curve alone; a second time, the usually shown ones.
void ChartsPanel::show_alone(std::size_t chart, std::size_t curve) {
  const std::size_t count = rows_.charts[chart]->spec().curves.size();
  bool alone = true;
  for (std::size_t i = 0; i < count; ++i) {
    alone = alone && (i == curve) == rows_.charts[chart]->curve_shown(i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    show_curve(chart, i, i == curve || (alone && !rows_.charts[chart]->spec().curves[i].on_demand));
  }
}

void ChartsPanel::set_second_cursor(std::optional<double> time) {
  const bool shown = time.has_value() && points_into_run();
  second_ = shown ? std::optional(std::clamp(*time, 0.0, trajectory_->duration())) : std::nullopt;
  show_cursor();
}

bool ChartsPanel::points_into_run() const {
  return columns_.envelope() != nullptr && cursor_.valid() && cursor_.trajectory() == trajectory_;
}

QString ChartsPanel::measurement_text() const {
  if (!second_.has_value() || !points_into_run()) {
    return {};
  }
  return text_of(measure(cursor_.state(), trajectory_->state(*second_)));
}

QString ChartsPanel::cursor_text() const {
  if (!points_into_run() || !(cursor_.state().time > 0)) {
    return {};
  }
  const State& state = cursor_.state();
  InstantSampler sampler(sources_, state.time);
  const Instant instant = sampler.at(state);
  const auto value = [&](QuantityId id) { return info_of(id).of(instant); };
  return QStringList{clock_text(state.time),
                     tr("%1 of %2")
                         .arg(number_text(value(QuantityId::feed), Dimension::feed),
                              amount_text(value(QuantityId::programmed_feed), Dimension::feed)),
                     amount_text(value(QuantityId::tangential_acceleration), Dimension::acceleration),
                     amount_text(value(QuantityId::tangential_jerk), Dimension::jerk),
                     cause_name(state.cause)}
      .join(QStringLiteral(" · "));
}

void ChartsPanel::refresh() {
  refresh_.stop();
  const int count = rows_.charts.front()->column_count();
  range_.set_end_beside(overlays_.end());
  columns_.update(range_, count);
  if (columns_.envelope() != nullptr) {
    overlays_.update(range_, *trajectory_, count);
  }
  usual_.follow(columns_, range_.rapids_shown());
  const auto feed = cutting_feed(columns_.envelope(), columns_.bands(), overlays_.runs());
  rows_.charts.front()->set_cutting_feed(feed);
  std::vector<MotionBand> cutting;
  if (feed && overlays_.traces().empty()) {  // recordings do not separate rapids
    cutting.push_back(columns_.envelope()->cutting());
    for (const RunOverlay& run : overlays_.runs()) {
      cutting.push_back(run.envelope->cutting());
    }
  }
  for (const std::size_t chart : {acceleration_chart, jerk_chart}) {
    rows_.charts[chart]->set_cutting(cutting);
  }
  rows_.charts[jerk_chart]->set_jumps(
      !sources_.limits_jerk ||
      std::ranges::any_of(overlays_.runs(), [](const RunOverlay& run) { return !run.sources.limits_jerk; }));
  rows_.show_columns(columns_, overlays_);
  causes_->set_causes(columns_.dominating(), columns_.causes());
  show_cursor();
}

void ChartsPanel::show_cursor() {
  const bool shown = points_into_run();
  const auto second = shown && second_.has_value()
                          ? std::optional(range_.position_of(trajectory_->state(*second_)))
                          : std::nullopt;
  for (std::size_t i = 0; i < rows_.charts.size(); ++i) {
    rows_.charts[i]->set_cursors(shown ? std::optional(range_.position_of(cursor_.state())) : std::nullopt,
                                 second);
  }
  rows_.show_values(shown ? &cursor_.state() : nullptr, sources_);
  rows_.lost->set_cursor(rows_.charts.front()->cursor(),
                         shown ? std::optional(cursor_.state().time) : std::nullopt);
  show_other_runs();
  const QString text = second_.has_value() ? measurement_text() : cursor_text();
  readout_->setText(text);
  readout_->setVisible(!text.isEmpty());
  place_readout();
  commands_->set_second_cursor(second_.has_value());
}

/// Shows the names of the other runs, and their values at the cursor.
void ChartsPanel::show_other_runs() {
  const bool valued = points_into_run();
  const auto position = valued ? std::optional(range_.position_of(cursor_.state())) : std::nullopt;
  for (std::size_t i = 0; i < rows_.headers.size(); ++i) {
    rows_.headers[i]->set_runs(
        overlays_.legend(i, rows_.charts[i]->spec(), range_, trajectory_.get(), position));
  }
}

void ChartsPanel::zoom(double factor) {
  const double at = points_into_run() ? range_.position_of(cursor_.state()) : -1;
  range_.zoom(factor,
              at >= range_.lower() && at <= range_.upper() ? at : (range_.lower() + range_.upper()) / 2);
}

void ChartsPanel::go_back() {
  rest();
  if (history_.can_go_back()) {
    show_view(history_.back());
  }
}

void ChartsPanel::go_forward() {
  rest();
  if (history_.can_go_forward()) {
    show_view(history_.forward());
  }
}

void ChartsPanel::move_cursor(int pixels) {
  if (points_into_run()) {
    const double pixel = (range_.upper() - range_.lower()) / rows_.charts.front()->plot().width();
    cursor_.set_time(range_.time_at(range_.position_of(cursor_.state()) + pixels * pixel));
  }
}

void ChartsPanel::zoom_to_cursors() {
  if (second_.has_value() && points_into_run()) {
    const auto [low, high] =
        std::minmax({range_.position_of(cursor_.state()), range_.position_of(trajectory_->state(*second_))});
    range_.show(low, high);
  }
}

void ChartsPanel::fit() {
  rows_.choose_values({});
  range_.fit();
}

void ChartsPanel::choose_abscissa(Abscissa abscissa) {
  columns_.clear();
  overlays_.clear();
  range_.set_abscissa(abscissa);
  show_charts_of_run();
}

void ChartsPanel::show_view(const ChartView& view) {
  range_.show_times(view.time.lower, view.time.upper);
  rows_.choose_values(view.values);
  rest_.stop();
  commands_->set_steps(history_.can_go_back(), history_.can_go_forward());
}

/// Starts the wait after a change of the view; the history records views that last.
void ChartsPanel::begin_rest() {
  rest_.start();
  commands_->set_steps(history_.can_go_back() || view() != history_.current(), history_.can_go_forward());
}

void ChartsPanel::rest() {
  rest_.stop();
  if (trajectory_ != nullptr) {
    history_.rest(view());
    commands_->set_steps(history_.can_go_back(), history_.can_go_forward());
  }
}

bool ChartsPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (key && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && second_.has_value()) {
    if (event->type() == QEvent::KeyPress) {
      set_second_cursor({});
    }
    event->accept();  // without a second cursor, the window uses Esc otherwise
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void ChartsPanel::draw(QPainter& painter) {
  painter.fillRect(rect(), palette().color(QPalette::Window));
  const QWidget& content = *scroll_->widget();
  rows_.draw(painter, content);
  draw_part(painter, content, *causes_, [&] { causes_->draw(painter); });
  draw_part(painter, content, *readout_, [&] {
    painter.fillRect(readout_->rect(), palette().color(QPalette::Text));
    painter.setFont(readout_->font());
    painter.setPen(palette().color(QPalette::Base));
    painter.drawText(readout_->contentsRect(), Qt::AlignVCenter, readout_->text());
  });
}

ChartsState ChartsPanel::state() const {
  ChartsState state;
  state.abscissa = range_.abscissa();
  state.causes = causes_->isVisibleTo(this);
  rows_.add_to(state);
  for (std::size_t i = 0; i < rows_.charts.size(); ++i) {
    if (const auto chosen = overlays_.chosen(i)) {
      state.other_runs.append(rows_.charts[i]->spec().curves[*chosen].key);
    }
  }
  if (awaiting_run_.has_value()) {
    state.time = awaiting_run_->time;
    state.second_cursor = awaiting_run_->second_cursor;
  } else if (held_.has_value()) {
    state.time = held_->state.time;
    state.second_cursor = held_->state.second_cursor;
  } else {
    state.time = range_.shows_all() ? std::nullopt : std::optional(view().time);
    state.second_cursor = second_;
  }
  return state;
}

void ChartsPanel::set_state(const ChartsState& state) {
  choose_abscissa(state.abscissa);
  for (std::size_t i = 0; i < rows_.charts.size(); ++i) {
    const std::vector<CurveSpec>& curves = rows_.charts[i]->spec().curves;
    std::optional<std::size_t> other;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      show_curve(i, k, is_shown(curves[k], state));
      if (state.other_runs.contains(curves[k].key)) {
        other = k;
      }
    }
    set_overlay_curve(i, other);
    rows_.hidden[i] = !is_shown(rows_.charts[i]->spec(), state);
    commands_->set_chart_shown(i, !rows_.hidden[i]);
  }
  show_charts_of_run();
  commands_->set_causes_shown(state.causes);
  show_range(state);
}

void ChartsPanel::show_range(const ChartsState& state) {
  awaiting_run_.reset();
  if (trajectory_ == nullptr) {
    awaiting_run_ = state;
  } else if (!state.time.has_value()) {
    range_.fit();
  } else {
    range_.show_times(state.time->lower, state.time->upper);
  }
  rows_.choose_values(state.values);
  set_second_cursor(state.second_cursor);
  rest();
}

}  // namespace feedscope::ui
