#include "ui/decide/decide_view.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/time/ruled_instant.h"
#include "core/base/error.h"
#include "core/machine/contour_tolerance.h"
#include "ui/decide/decision_chart.h"
#include "ui/decide/tolerance_dialog.h"
#include "ui/fields/number_box.h"
#include "ui/language/in_language.h"
#include "ui/language/remedy_text.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/language/time_texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/theme/cause_colours.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

constexpr double usual_bound = 0.02;  // [mm]
constexpr double largest_bound = 1;   // [mm]
constexpr std::size_t most_causes = 4;
constexpr std::size_t most_rows = 8;  // of the table that are visible at once
constexpr int margin = 8;
enum Column { name_column, time_column, against_column, error_column, column_count };

QLabel* make_text(QWidget* parent, int pixels, bool bold = false) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QFont font = label->font();
  font.setBold(bold);
  label->setFont(font);
  set_type_pixels(*label, pixels);
  return label;
}

/// A sample of the run's line.
QIcon line_icon(const RunItem& item, std::size_t row, const QWidget& widget) {
  constexpr QSize size(18, 12);
  const double ratio = widget.devicePixelRatioF();
  QPixmap picture(size * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  QPen pen(item.colour, 2);
  if (const QList<qreal> dashes = run_dashes(row); !dashes.isEmpty()) {
    pen.setDashPattern(dashes);
  }
  pen.setCapStyle(Qt::FlatCap);
  painter.setPen(pen);
  painter.drawLine(QPointF(0, size.height() / 2.0), QPointF(size.width(), size.height() / 2.0));
  painter.end();
  return picture;
}

}  // namespace

DecideView::DecideView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("decide"), tr("Decide"), Qt::RightDockWidgetArea}, parent),
      workbench_(workbench),
      runs_(workbench.runs()),
      compare_(make_action(this, tr("Compare &tolerances …"),
                           tr("Simulate the program with several contour tolerances and decide between them"),
                           QKeySequence(tr("Ctrl+T")), &DecideView::ask)),
      compare_tip_(compare_->toolTip()),
      headline_(make_text(this, 15, true)),
      rule_(make_text(this, 12)),
      offer_(new QPushButton(compare_->text(), this)),
      chart_(new DecisionChart(this)),
      bounded_(new QCheckBox(tr("Ma&x. error"), this)),
      bound_(new NumberBox(this)),
      table_(new QTreeWidget(this)),
      causes_title_(make_text(this, 12, true)),
      causes_(new ShareBars(this)),
      help_title_(make_text(this, 12, true)),
      help_(new QGridLayout) {
  set_everyday_words(compare_, tr("compare runs variants decide"));
  table_->setColumnCount(column_count);
  table_->setRootIsDecorated(false);
  table_->setIndentation(0);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setAccessibleName(tr("Runs and their results"));
  table_->setIconSize({18, 12});
  table_->setAllColumnsShowFocus(true);
  table_->header()->setStretchLastSection(false);
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(name_column, QHeaderView::Stretch);
  table_->header()->setMinimumSectionSize(1);
  set_type_pixels(*table_, 11);
  install_row_copy(*table_);
  help_title_->setText(tr("What would help"));
  make_bound();
  make_layout();
  connect_runs();
  follow_palette();
  show_all();
}

void DecideView::make_bound() {
  const QString tip = tr("Only runs with a contour error within this bound are recommended");
  bounded_->setToolTip(tip);
  bound_->setToolTip(tip);
  bound_->setRange(0, in_shown_unit(largest_bound, Dimension::error));
  bound_->setDecimals(decimals_of(Dimension::error, 1));
  bound_->setSuffix(' ' + unit_of(Dimension::error));
  bound_->setValue(in_shown_unit(runs_.error_bound().value_or(usual_bound), Dimension::error));
  bounded_->setChecked(runs_.error_bound().has_value());
  bound_->setEnabled(bounded_->isChecked());
  connect(bounded_, &QCheckBox::toggled, this, &DecideView::set_bound);
  connect(bound_, &NumberBox::valueChanged, this, &DecideView::set_bound);
  connect(chart_, &DecisionChart::bound_dragged, this,
          [this](double bound) { bound_->setValue(in_shown_unit(bound, Dimension::error)); });
}

void DecideView::make_layout() {
  auto* inside = new QWidget;
  auto* layout = new QVBoxLayout(inside);
  layout->setContentsMargins(margin, margin, margin, margin);
  layout->setSpacing(6);
  auto* bound = new QHBoxLayout;
  bound->addWidget(bounded_);
  bound->addWidget(bound_);
  bound->addStretch(1);
  auto* offer = new QHBoxLayout;
  offer->addWidget(offer_);
  offer->addStretch(1);
  help_->setColumnStretch(0, 1);
  help_->setVerticalSpacing(2);
  layout->addWidget(headline_);
  layout->addWidget(rule_);
  layout->addLayout(offer);
  layout->addWidget(chart_);
  layout->addLayout(bound);
  layout->addWidget(table_);
  layout->addSpacing(6);
  layout->addWidget(causes_title_);
  layout->addWidget(causes_);
  layout->addSpacing(6);
  layout->addWidget(help_title_);
  layout->addLayout(help_);
  layout->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(inside);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
}

void DecideView::connect_runs() {
  for (const auto signal :
       {&RunList::list_changed, &RunList::current_changed, &RunList::error_bound_changed}) {
    connect(&runs_, signal, this, &DecideView::refresh);
  }
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed, &RunList::status_changed}) {
    connect(&runs_, signal, this, &DecideView::refresh);
  }
  connect(&workbench_, &Workbench::program_changed, this, &DecideView::refresh);
  connect(&workbench_.time_findings(), &TimeFindings::changed, this, &DecideView::refresh);
  connect(&workbench_.time_findings(), &TimeFindings::state_changed, this, &DecideView::refresh);
  connect(offer_, &QPushButton::clicked, compare_, &QAction::trigger);
  connect(chart_, &DecisionChart::run_clicked, &runs_, &RunList::select);
  connect(table_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!showing_ && item != nullptr) {
      runs_.select(static_cast<std::size_t>(table_->indexOfTopLevelItem(item)));
    }
  });
  connect(table_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int) {
    if (!showing_) {
      runs_.set_visible(static_cast<std::size_t>(table_->indexOfTopLevelItem(item)),
                        item->checkState(name_column) == Qt::Checked);
    }
  });
  connect(causes_, &ShareBars::clicked, this, &DecideView::go_to_cause);
}

void DecideView::set_on_screen(bool on_screen) {
  on_screen_ = on_screen;
  watch();
}

void DecideView::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  watch();
}

void DecideView::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  watch();
}

void DecideView::changeEvent(QEvent* event) {
  Panel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    follow_palette();
    refresh();
  } else if (event->type() == QEvent::FontChange) {
    refresh();
  }
}

/// Makes the chosen row pale: the lines of the runs stay visible on it.
void DecideView::follow_palette() {
  QPalette colours = palette();
  QColor chosen = colours.color(QPalette::Highlight);
  constexpr float pale = 0.22F;
  chosen.setAlphaF(pale);
  colours.setColor(QPalette::Highlight, chosen);
  colours.setColor(QPalette::HighlightedText, colours.color(QPalette::Text));
  table_->setPalette(colours);
}

void DecideView::watch() {
  workbench_.time_findings().set_watched(this, on_screen_ && isVisible());
}

void DecideView::ask() {
  if (const std::vector<SetupState> setups = ToleranceDialog::ask(runs_, this); !setups.empty()) {
    compare_with(setups);
    emit attention_wanted();
  }
}

void DecideView::compare_with(const std::vector<SetupState>& setups) {
  choosing_ = true;
  runs_.history().beginMacro(tr("compare runs"));
  for (const SetupState& setup : setups) {
    runs_.duplicate_as(runs_.current(), setup);
  }
  runs_.history().endMacro();
}

void DecideView::set_bound() {
  bound_->setEnabled(bounded_->isChecked());
  runs_.set_error_bound(bounded_->isChecked()
                            ? std::optional(from_shown_unit(bound_->value(), Dimension::error))
                            : std::nullopt);
}

void DecideView::refresh() {
  if (!std::exchange(refreshing_, true)) {
    QMetaObject::invokeMethod(this, &DecideView::show_all, Qt::QueuedConnection);
  }
}

void DecideView::show_all() {
  refreshing_ = false;
  choose_best();
  const bool takes_tolerance = runs_.current_item().setup.file().settings.has(contour_tolerance_key);
  compare_->setEnabled(takes_tolerance);
  compare_->setToolTip(
      takes_tolerance
          ? compare_tip_
          : tr("This control has no contour tolerance; choose another one to compare tolerances"));
  offer_->setVisible(runs_.items().size() < 2 && takes_tolerance && workbench_.program() != nullptr);
  show_decision();
  show_chart();
  show_table();
  show_causes();
  show_help();
}

void DecideView::choose_best() {
  if (!choosing_) {
    return;
  }
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    if (runs_.status(row) == RunStatus::waiting) {
      return;
    }
  }
  choosing_ = false;
  if (const auto taken = recommended(runs_)) {
    runs_.select(taken->run);
    Cursor& cursor = workbench_.cursor();
    if (cursor.valid() && !(cursor.state().time > 0)) {  // where the lens shows the effect of a tolerance
      cursor.set_time(runs_.result(taken->run)->run.summary.worst_place.time);
    }
  }
}

QString DecideView::progress_text() const {
  const std::size_t count = runs_.items().size();
  std::size_t done = 0;
  std::size_t given_up = 0;
  for (std::size_t row = 0; row < count; ++row) {
    const RunStatus status = runs_.status(row);
    done += status == RunStatus::simulated ? 1 : 0;
    given_up += status == RunStatus::cancelled || status == RunStatus::failed ? 1 : 0;
  }
  if (given_up > 0) {
    return tr("%1 of %2 runs are simulated; %3 were cancelled or failed.").arg(done).arg(count).arg(given_up);
  }
  return done < count ? tr("%1 of %2 runs are simulated.").arg(done).arg(count) : QString();
}

void DecideView::show_decision() {
  QString headline;
  QString rule;
  const TimeFindings& findings = workbench_.time_findings();
  if (workbench_.program() == nullptr) {
    headline = tr("Open a program to see what its time is lost to.");
  } else if (runs_.items().size() > 1) {
    const Decision decision = DecisionTexts::decision(runs_);
    headline = decision.headline;
    rule = decision.rule;
    bool waits = false;
    for (std::size_t row = 0; row < runs_.items().size(); ++row) {
      waits = waits || runs_.status(row) == RunStatus::waiting;
    }
    if (headline.isEmpty() || waits) {
      headline = progress_text();
      rule.clear();
    }
  } else if (findings.shown() != nullptr && is_refused(findings.shown()->run)) {
    rule = TimeTexts::refusal(findings.shown()->run);
  } else if (findings.report() != nullptr) {
    const Summary& summary = findings.shown()->run.summary;
    headline = DecisionTexts::single(summary);
    rule = tr("Programmed: %1, at the programmed feed.").arg(clock_text(summary.programmed_time));
  }
  headline_->setText(headline);
  headline_->setVisible(!headline.isEmpty());
  rule_->setText(rule);
  rule_->setVisible(!rule.isEmpty());
}

void DecideView::show_chart() {
  const auto taken = recommended(runs_);
  std::vector<DecisionDot> dots;
  std::size_t least_refused = std::numeric_limits<std::size_t>::max();  // the others run less
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    const auto result = runs_.result(row);
    if (result != nullptr && !is_refused(result->run)) {
      least_refused = std::min(least_refused, result->run.lines_not_run.size());
    }
  }
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    const auto result = runs_.result(row);
    if (result != nullptr && !is_refused(result->run) && result->run.lines_not_run.size() == least_refused) {
      dots.push_back({row, result->run.summary.cycle_time, deciding_error(result->run.summary),
                      run_letter(row), runs_.items()[row].colour, taken && taken->run == row,
                      row == runs_.current(), result->run.summary.actual.has_value()});
    }
  }
  const bool several = dots.size() > 1;
  chart_->setVisible(several);
  bounded_->setVisible(several);
  bound_->setVisible(several);
  chart_->set(std::move(dots), runs_.error_bound());
}

void DecideView::show_table() {
  showing_ = true;
  const bool several = runs_.items().size() > 1;
  table_->setVisible(several);
  table_->clear();
  const auto taken = recommended(runs_);
  const std::size_t against = taken ? taken->against : 0;
  table_->setHeaderLabels({tr("Run"), tr("Time"), tr("Against\n%1").arg(run_letter(against)),
                           tr("Error %1").arg(unit_of(Dimension::error)).replace(' ', '\n')});
  for (int column = 1; column < column_count; ++column) {
    table_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  if (several) {
    for (std::size_t row = 0; row < runs_.items().size(); ++row) {
      add_row(row, against, taken && taken->run == row);
    }
    table_->setCurrentItem(table_->topLevelItem(static_cast<int>(runs_.current())));
    const auto rows = static_cast<int>(std::min(most_rows, runs_.items().size()));
    table_->setFixedHeight(table_->header()->sizeHint().height() + rows * (table_->sizeHintForRow(0)) + 4);
  }
  showing_ = false;
}

void DecideView::add_row(std::size_t row, std::size_t against, bool taken) {
  auto* item = new QTreeWidgetItem(table_);
  const RunItem& run = runs_.items()[row];
  item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
  item->setCheckState(name_column, run.visible ? Qt::Checked : Qt::Unchecked);
  item->setIcon(name_column, line_icon(run, row, *this));
  item->setText(name_column, runs_.lettered_title(row));
  item->setToolTip(name_column, runs_.title(run));
  const auto result = runs_.result(row);
  if (result == nullptr) {
    const RunStatus status = runs_.status(row);
    item->setText(time_column, status == RunStatus::cancelled ? tr("cancelled")
                               : status == RunStatus::failed  ? tr("failed")
                                                              : QStringLiteral("…"));
  } else if (is_refused(result->run)) {
    item->setText(time_column, tr("refused"));
  } else {
    const Summary& summary = result->run.summary;
    item->setText(time_column, clock_text(summary.cycle_time));
    item->setText(error_column, number_text(deciding_error(summary), Dimension::error));
    if (const auto other = runs_.result(against)) {
      item->setText(against_column, DecisionTexts::against(result->run, other->run));
    }
    if (!keeps_bound(deciding_error(summary), runs_.error_bound())) {
      for (int column = 0; column < column_count; ++column) {
        item->setForeground(column, theme_colours(palette()).muted);
      }
      item->setToolTip(error_column, tr("Above the bound"));
    }
  }
  QFont font = table_->font();
  font.setBold(taken);
  for (int column = 0; column < column_count; ++column) {
    item->setFont(column, font);
    if (column > 0) {
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
}

void DecideView::show_causes() {
  const TimeFindings& findings = workbench_.time_findings();
  std::vector<ShareBarRow> rows;
  if (findings.report() != nullptr) {
    const std::vector<SlowGroup>& groups = findings.report()->slow.groups;
    for (std::size_t i = 0; i < std::min(most_causes, groups.size()); ++i) {
      rows.push_back(
          {TimeTexts::group(groups[i]), TimeTexts::change(groups[i].loss),
           groups[i].loss / groups.front().loss, colour_of_cause(groups[i].kind, theme_of(palette())),
           tr("%1.\nClick to go to the worst place, in line %2.")
               .arg(TimeTexts::in_common(groups[i]), QString::number(groups[i].worst.front().line))});
    }
  }
  const bool several = runs_.items().size() > 1;
  const QStringList names = short_run_titles(runs_.items(), runs_.feed_controls());
  causes_title_->setText(
      several ? tr("Where the time of %1 is lost").arg(names[static_cast<qsizetype>(runs_.current())])
              : tr("Where the time is lost"));
  causes_title_->setVisible(!rows.empty());
  causes_->setVisible(!rows.empty());
  causes_->set(std::move(rows));
}

void DecideView::show_help() {
  while (QLayoutItem* item = help_->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  tries_.clear();
  const TimeFindings& findings = workbench_.time_findings();
  help_title_->setVisible(findings.trying() || findings.tried());
  if (findings.trying() && !findings.tried()) {
    auto* state = make_text(this, 12);
    state->setText(tr("Simulating what would help …"));
    help_->addWidget(state, 0, 0);
    return;
  }
  if (!findings.tried()) {
    return;
  }
  const TimeReport& report = *findings.report();
  int row = 0;
  for (const std::size_t best : report.changes.best) {
    const TriedChange& change = report.changes.tried[best];
    auto* text = make_text(this, 12);
    text->setText(remedy_text(change.remedy, findings.shown()->run.setup));
    text->setMinimumWidth(1);  // it takes the room left by the others
    auto* gain = make_text(this, 12);
    gain->setWordWrap(false);
    gain->setText(TimeTexts::change(change.cycle_time - report.use.cycle_time));
    auto* button = new QPushButton(tr("Try"), this);
    constexpr int around_text = 24;
    button->setFixedWidth(fontMetrics().horizontalAdvance(button->text()) + type_pixels(around_text));
    button->setToolTip(tr("Make a run with this change"));
    button->setAccessibleName(tr("Try: %1").arg(text->text()));
    connect(button, &QPushButton::clicked, this, [this, remedy = change.remedy] { try_change(remedy); });
    help_->addWidget(text, row, 0);
    help_->addWidget(gain, row, 1, Qt::AlignRight | Qt::AlignVCenter);
    help_->addWidget(button, row, 2);
    tries_.append(button);
    ++row;
  }
  if (row == 0) {
    auto* none = make_text(this, 12);
    none->setText(tr("None of the changes that were simulated helps."));
    help_->addWidget(none, 0, 0);
  }
}

void DecideView::try_change(const Remedy& remedy) {
  try {
    runs_.duplicate_as(runs_.current(), workbench_.time_findings().changed_by(remedy));
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

void DecideView::go_to_cause(std::size_t row) {
  const TimeFindings& findings = workbench_.time_findings();
  if (findings.report() == nullptr || row >= findings.report()->slow.groups.size()) {
    return;
  }
  const SlowPlace& place = findings.report()->slow.groups[row].worst.front();
  workbench_.show_place(ruled_instant(*findings.shown()->run.trajectory, place), place.from, place.to);
}

QList<QPushButton*> DecideView::tries() const {
  return tries_;
}

QString DecideView::headline() const {
  return headline_->text();
}

QString DecideView::rule() const {
  return rule_->text();
}

}  // namespace feedscope::ui
