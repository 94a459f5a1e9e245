#include "ui/circular/circular_view.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/export/circular.h"
#include "ui/charts/chart_export.h"
#include "ui/circular/circular_table.h"
#include "ui/circular/circular_texts.h"
#include "ui/circular/polar_plot.h"
#include "ui/fields/focus_outline.h"
#include "ui/fields/number_box.h"
#include "ui/fields/number_list_field.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {
namespace {

constexpr double largest_radius = 1e4;  // [mm]
constexpr int row_height = 22;          // [pixels]

/// Numbers of a field in the shown unit, without the digits that the conversion adds.
std::vector<double> shown_numbers(const std::vector<double>& values, Dimension dimension, int decimals) {
  const double step = std::pow(10.0, decimals_of(dimension, decimals));
  std::vector<double> numbers;
  for (const double value : values) {
    numbers.push_back(std::round(in_shown_unit(value, dimension) * step) / step);
  }
  return numbers;
}

std::vector<double> from_shown(const NumberListField& field, Dimension dimension) {
  std::vector<double> values = field.numbers();
  for (double& value : values) {
    value = from_shown_unit(value, dimension);
  }
  return values;
}

}  // namespace

CircularView::CircularView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("circular"), tr("Circular test"), Qt::BottomDockWidgetArea, false}, parent),
      workbench_(workbench),
      source_(new QComboBox(this)),
      fields_(new QWidget(this)),
      radii_(new NumberListField(this)),
      feeds_(new NumberListField(this)),
      with_entry_(new QCheckBox(tr("&Entry arc"), this)),
      entry_(new NumberBox(this)),
      plane_(new QComboBox(this)),
      run_(new QPushButton(tr("Te&st"), this)),
      message_(new QLabel(this)),
      results_(new QSplitter(this)),
      table_(new CircularTable(this)),
      list_(new QTableView(this)),
      plot_(new PolarPlot(this)) {
  make_fields();
  make_list();
  make_actions();
  make_layout();
  set_state(CircularState());
  connect(source_, &QComboBox::currentIndexChanged, this, &CircularView::change_source);
  connect(run_, &QPushButton::clicked, this, [this] { busy() ? job_.cancel() : run(); });
  connect(radii_, &QLineEdit::returnPressed, this, &CircularView::run);
  connect(feeds_, &QLineEdit::returnPressed, this, &CircularView::run);
  connect(&workbench_.setup(), &SetupEdit::values_changed, this, &CircularView::forget);
  connect(&workbench_.setup(), &SetupEdit::keys_changed, this, &CircularView::forget);
  connect(&workbench_, &Workbench::run_changed, this, &CircularView::evaluate_program);
  change_source();
}

void CircularView::make_fields() {
  source_->addItem(tr("Circle to test"));
  source_->addItem(tr("Circles of the program"));
  source_->setToolTip(tr("What is evaluated: circles of your choice, or the full circles of the program"));
  source_->setAccessibleName(tr("Source"));
  radii_->setToolTip(tr("Radius of the circle; several with blanks between them make a table"));
  radii_->setAccessibleName(tr("Radii"));
  feeds_->setToolTip(tr("Programmed feed; several with blanks between them make a table"));
  feeds_->setAccessibleName(tr("Feeds"));
  entry_->setDecimals(decimals_of(Dimension::length, 3));
  entry_->setRange(0, in_shown_unit(largest_radius, Dimension::length));
  entry_->setSuffix(' ' + unit_of(Dimension::length));
  entry_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  entry_->setToolTip(tr("Radius of the quarter circles"));
  entry_->setEnabled(false);
  with_entry_->setToolTip(tr(
      "A quarter circle leads in and one out, as in a bore; without it the circle runs from rest to rest"));
  connect(with_entry_, &QCheckBox::toggled, entry_, &QWidget::setEnabled);
  for (const CirclePlane plane : {CirclePlane::xy, CirclePlane::zx, CirclePlane::yz}) {
    plane_->addItem(QString::fromLatin1(info_of(plane).name.data()));
  }
  plane_->setToolTip(tr("Plane of the circle"));
  plane_->setAccessibleName(tr("Plane"));
  run_->setToolTip(tr("Simulate the circle in both directions on this machine and control"));
  message_->setWordWrap(true);
}

void CircularView::make_list() {
  list_->setModel(table_);
  list_->setAccessibleName(tr("Values of the circular test"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setTabKeyNavigation(false);
  list_->setSelectionBehavior(QAbstractItemView::SelectRows);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->setWordWrap(false);
  list_->verticalHeader()->hide();
  list_->verticalHeader()->setDefaultSectionSize(row_height);
  list_->horizontalHeader()->setHighlightSections(false);
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  install_row_copy(*list_);
  new FocusOutline(*list_);
  connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &CircularView::show_selected);
}

void CircularView::make_actions() {
  actions_.append(make_action(this, tr("&Circular test (ISO 230-4) …"),
                              tr("Circularity and radial errors of a circle on this machine and control"), {},
                              [this] { emit attention_wanted(); }));
  actions_.append(make_action(this, tr("Copy the values of the circular test"),
                              tr("Copy circularity and radial errors to the clipboard"), {}, [this] {
                                if (table_->tests().empty()) {
                                  show_idle(nothing_yet());
                                  return;
                                }
                                QApplication::clipboard()->setText(rows_text(*table_));
                              }));
  actions_.append(make_action(this, tr("Save the values of the circular test as CSV …"),
                              tr("One row per circle and direction, with units"), {},
                              [this] { save_table(); }));
  actions_.append(make_action(this, tr("Save the picture of the circular test …"),
                              tr("The polar plot as PNG or SVG"), {}, [this] { save_picture(); }));
}

void CircularView::make_layout() {
  auto* below = new QHBoxLayout(fields_);
  below->setContentsMargins(0, 0, 0, 0);
  below->addWidget(new QLabel(with_unit_of(tr("Radii"), Dimension::length), fields_));
  below->addWidget(radii_, 1);
  below->addWidget(new QLabel(with_unit_of(tr("Feeds"), Dimension::feed), fields_));
  below->addWidget(feeds_, 1);
  auto* bar = new QHBoxLayout;
  bar->addWidget(source_);
  for (QWidget* field : std::initializer_list<QWidget*>{plane_, with_entry_, entry_, run_}) {
    bar->addWidget(field);
  }
  bar->addStretch();
  auto* head = new QVBoxLayout;
  head->setContentsMargins(4, 4, 4, 2);
  head->setSpacing(3);
  head->addLayout(bar);
  head->addWidget(fields_);
  head->addWidget(message_);
  plot_->show_values(false);
  results_->addWidget(plot_);
  results_->addWidget(list_);
  results_->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(results_, 1);
}

/// Places table and plot side by side if there is room.
void CircularView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int wide = 760;
  const Qt::Orientation suits = width() >= wide ? Qt::Horizontal : Qt::Vertical;
  if (results_->orientation() != suits || event->oldSize().width() <= 0) {
    results_->setOrientation(suits);
    results_->setSizes(suits == Qt::Horizontal ? QList<int>{800, 1200} : QList<int>{1000, 1000});
  }
}

void CircularView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  evaluate_program();
}

void CircularView::set_on_screen(bool on_screen) {
  on_screen_ = on_screen;
  evaluate_program();
}

bool CircularView::of_program() const {
  return source_->currentIndex() == 1;
}

CircularState CircularView::state() const {
  CircularState state;
  state.of_program = of_program();
  state.radii = from_shown(*radii_, Dimension::length);
  state.feeds = from_shown(*feeds_, Dimension::feed);
  for (double& feed : state.feeds) {
    feed = units::to_mm_min(feed);
  }
  state.plane = static_cast<CirclePlane>(plane_->currentIndex());
  state.entry_arc = with_entry_->isChecked();
  state.entry_radius = from_shown_unit(entry_->value(), Dimension::length);
  return state;
}

void CircularView::set_state(const CircularState& state) {
  std::vector<double> feeds = state.feeds;
  for (double& feed : feeds) {
    feed = units::from_mm_min(feed);
  }
  radii_->set_numbers(shown_numbers(state.radii, Dimension::length, 3));
  feeds_->set_numbers(shown_numbers(feeds, Dimension::feed, 1));
  plane_->setCurrentIndex(static_cast<int>(state.plane));
  with_entry_->setChecked(state.entry_arc);
  entry_->setValue(in_shown_unit(state.entry_radius, Dimension::length));
  source_->setCurrentIndex(state.of_program ? 1 : 0);
}

void CircularView::change_source() {
  for (QWidget* field : std::initializer_list<QWidget*>{fields_, plane_, with_entry_, entry_, run_}) {
    field->setVisible(!of_program());
  }
  list_->setColumnHidden(CircularTable::line, !of_program());
  list_->setColumnHidden(CircularTable::center, !of_program());
  plot_->set_hint(of_program() ? tr("The full circles of the program are drawn here.")
                               : tr("A circle in both directions: choose radius and feed, then press Test."));
  forget();
  evaluate_program();
}

void CircularView::run() {
  forget();
  for (const NumberListField* field : {radii_, feeds_}) {
    if (!field->problem().isEmpty()) {
      show_idle(QStringLiteral("%1: %2").arg(field->accessibleName(), field->problem()));
      return;
    }
  }
  try {
    std::vector<CircularRequest> requests = requests_of(state());
    run_->setText(tr("&Cancel"));
    message_->setText(tr("Simulating …"));
    message_->show();
    job_.test(std::move(requests), workbench_.setup().setup(),
              [this](const JobOutcome<CircularResult>& outcome) { take(outcome); });
  } catch (const InputError& error) {
    show_idle(failure_text(error));
  }
}

/// Evaluates each run once, and only while the panel is visible.
void CircularView::evaluate_program() {
  if (!of_program() || !on_screen_ || !isVisible()) {
    return;
  }
  const auto shown = workbench_.shown();
  if (shown != nullptr && evaluated_.lock() == shown) {
    return;
  }
  forget();
  if (shown == nullptr) {
    show_idle(workbench_.program() == nullptr ? tr("Open a program to see its full circles.")
                                              : tr("This run has not been simulated."));
    return;
  }
  evaluated_ = shown;
  message_->setText(tr("Evaluating the circles of the program …"));
  message_->show();
  job_.evaluate(shown, [this](const JobOutcome<CircularResult>& outcome) { take(outcome); });
}

void CircularView::take(const JobOutcome<CircularResult>& outcome) {
  if (!outcome.result) {
    show_idle(outcome.cancelled() ? tr("Cancelled.") : outcome.failure);
    return;
  }
  show_again({*outcome.result, 0});
}

std::optional<CircularShown> CircularView::shown() const {
  return of_program() || !result_ ? std::nullopt
                                  : std::optional<CircularShown>({*result_, list_->currentIndex().row()});
}

void CircularView::show_again(CircularShown shown) {
  result_ = std::move(shown.result);
  table_->set_tests(result_->tests);
  show_idle(circular_message(*result_));
  if (table_->rowCount() > 0) {
    list_->selectRow(std::clamp(shown.row, 0, table_->rowCount() - 1));
  }
}

void CircularView::show_selected() {
  const QModelIndex index = list_->currentIndex();
  if (!index.isValid()) {
    plot_->set_tests({}, {}, {});
    return;
  }
  const Setup setup = workbench_.setup().setup();
  plot_->set_tests(
      of_program() ? tr("Circle of the program (ISO 230-4)") : tr("Circular test (ISO 230-4)"),
      tr("%1, model %2")
          .arg(QString::fromStdString(setup.machine.name), QString::fromStdString(setup.model->info().id)),
      {table_->test_of(index.row())});
}

/// Discards the results: another machine or control would produce another circle.
void CircularView::forget() {
  if (busy()) {
    job_.cancel();
  }
  evaluated_.reset();
  result_.reset();
  table_->set_tests({});
  plot_->set_tests({}, {}, {});
  show_idle({});
}

void CircularView::show_idle(const QString& message) {
  run_->setText(tr("Te&st"));
  message_->setText(message);
  message_->setVisible(!message.isEmpty());
}

QString CircularView::message() const {
  return message_->text();
}

QString CircularView::nothing_yet() const {
  return of_program() ? tr("The program has no full circle to copy or save.")
                      : tr("There is no circular test yet: press Test first.");
}

void CircularView::save_table() {
  if (table_->tests().empty()) {
    show_idle(nothing_yet());
    return;
  }
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the circular test"), {}, tr("Tables (*.csv)"));
  std::string text;
  if (of_program()) {
    ProgramCircles circles;
    circles.tests = table_->tests();
    text = program_circles_csv(circles);
  } else {
    text = circular_csv(table_->tests());
  }
  QSaveFile out(file);
  const auto size = static_cast<qint64>(text.size());
  if (!file.isEmpty() &&
      (!out.open(QIODevice::WriteOnly) || out.write(text.data(), size) != size || !out.commit())) {
    show_idle(tr("%1 cannot be written: %2. Choose another folder.").arg(file, out.errorString()));
  }
}

void CircularView::save_picture() {
  if (plot_->tests().empty()) {
    show_idle(nothing_yet());
    return;
  }
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the picture of the circular test"),
                                   QStringLiteral("circle.png"), tr("Pictures (*.png *.svg)"));
  if (file.isEmpty()) {
    return;
  }
  const QSize size = plot_->sizeHint();
  try {
    feedscope::ui::save_picture(file, size, tr("Circular test (ISO 230-4)"), [&](QPainter& painter) {
      plot_->draw(painter, QRectF(QPointF(), QSizeF(size)));
    });
  } catch (const InputError& error) {
    show_idle(failure_text(error));
  }
}

}  // namespace feedscope::ui
