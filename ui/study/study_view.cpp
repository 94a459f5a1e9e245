#include "ui/study/study_view.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/analysis/notes/slower_tolerance.h"
#include "core/analysis/study/recommendation.h"
#include "core/base/error.h"
#include "core/export/export.h"
#include "core/machine/contour_tolerance.h"
#include "core/toolpath/turn_limiter.h"
#include "ui/fields/focus_outline.h"
#include "ui/fields/number_box.h"
#include "ui/fields/whole_number_box.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {

namespace {

constexpr int row_height = 22;
constexpr int usual_count = 12;
constexpr double usual_bound = 10;  // [um]
const std::string tolerance = "tolerance";

/// The setup's setting for a sweep of `key`.
std::string setting_of(const std::string& key) {
  return key == tolerance ? contour_tolerance_key : key;
}

SetupState with_value(SetupState setup, const std::string& key, double value) {
  key == tolerance ? setup.set_tolerance(value) : setup.set(key, value);
  return setup;
}

/// Rounds to as few digits as distinguish the values, at least two: people can set 0.0066 mm. The ends are
/// unchanged.
Sweep rounded(Sweep sweep) {
  constexpr int most = 5;
  for (int digits = 2; digits <= most; ++digits) {
    Sweep tried = sweep;
    for (std::size_t i = 1; i + 1 < tried.values.size(); ++i) {
      tried.values[i] = QLocale::c().toDouble(QLocale::c().toString(tried.values[i], 'g', digits));
    }
    const bool rising = std::ranges::is_sorted(tried.values, std::less_equal<>());
    const bool falling = std::ranges::is_sorted(tried.values, std::greater_equal<>());
    if (rising || falling) {
      return tried;
    }
  }
  return sweep;
}

/// Times of the shown traces that cover the whole program.
std::vector<RecordedTime> recorded_times(const TraceList& traces) {
  std::vector<RecordedTime> recorded;
  for (std::size_t row = 0; row < traces.items().size(); ++row) {
    const TraceItem& item = traces.items()[row];
    const auto shown = traces.result(row);
    if (item.visible && shown != nullptr && shown->agreement.whole) {
      recorded.push_back({item.name, item.colour, shown->agreement.measured_time, shown->agreement.distance});
    }
  }
  return recorded;
}

}  // namespace

StudyView::StudyView(Workbench& workbench, QWidget* parent)
    : Panel({QStringLiteral("study"), tr("Study"), Qt::BottomDockWidgetArea, false}, parent),
      workbench_(workbench),
      studied_(workbench.setup().state()),
      results_(new StudyTable(this)),
      key_(new QComboBox(this)),
      from_(new NumberBox(this)),
      to_(new NumberBox(this)),
      count_(new WholeNumberBox(this)),
      logarithmic_(new QCheckBox(tr("&Logarithmic"), this)),
      bounded_(new QCheckBox(tr("Ma&x. error"), this)),
      bound_(new NumberBox(this)),
      run_(new QPushButton(tr("&Study"), this)),
      adopt_(new QPushButton(tr("&Create run"), this)),
      progress_(new QProgressBar(this)),
      verdict_(new QLabel(this)),
      chart_(new StudyChart(this)),
      table_(new QTableView(this)) {
  make_fields();
  make_actions();
  make_layout();
  connect(run_, &QPushButton::clicked, this, [this] { busy() ? job_.cancel() : run(); });
  connect(adopt_, &QPushButton::clicked, this, [this] { make_run(table_->currentIndex().row()); });
  connect(key_, &QComboBox::currentIndexChanged, this, &StudyView::propose_range);
  connect(chart_, &StudyChart::run_clicked, this,
          [this](std::size_t, std::size_t point) { table_->selectRow(static_cast<int>(point)); });
  connect(table_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { make_run(index.row()); });
  connect(&job_, &StudyJob::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(100 * fraction)); });
  connect(&job_, &StudyJob::finished, this, &StudyView::take);
  connect(&job_, &StudyJob::cancelled, this, [this] {
    show_idle();
    verdict_->setText(tr("Cancelled."));
  });
  connect(&job_, &StudyJob::failed, this, [this](const QString& message) {
    show_idle();
    verdict_->setText(message);
  });
  connect(&workbench_.setup(), &SetupEdit::keys_changed, this, &StudyView::list_keys);
  connect(&workbench_, &Workbench::program_changed, this, &StudyView::forget);
  connect(&workbench_.traces(), &TraceList::list_changed, this, &StudyView::follow_traces);
  connect(&workbench_.traces(), &TraceList::changed, this, &StudyView::follow_traces);
  list_keys();
  show_idle();
}

void StudyView::make_fields() {
  constexpr double largest_value = 1e9;
  for (NumberBox* end : {from_, to_}) {
    end->setDecimals(5);
    end->setRange(0, largest_value);
    end->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  from_->setToolTip(tr("First value of the setting, in its unit"));
  to_->setToolTip(tr("Last value of the setting, in its unit"));
  count_->setRange(2, static_cast<int>(max_sweep_values));
  count_->setValue(usual_count);
  count_->setToolTip(tr("Number of values"));
  logarithmic_->setChecked(true);
  logarithmic_->setToolTip(tr("Logarithmic steps from value to value"));
  bound_->setRange(0, in_shown_unit(1, Dimension::error));
  bound_->setDecimals(decimals_of(Dimension::error, 1));
  bound_->setValue(in_shown_unit(usual_bound / 1000, Dimension::error));
  bound_->setSuffix(' ' + unit_of(Dimension::error));
  bounded_->setChecked(true);
  bounded_->setToolTip(tr("Only runs with a contour error within this bound are considered for the fastest"));
  bound_->setToolTip(bounded_->toolTip());
  connect(bounded_, &QCheckBox::toggled, bound_, &QWidget::setEnabled);
  key_->setToolTip(tr("Setting to vary"));
  key_->setAccessibleName(tr("Setting"));
  verdict_->setWordWrap(true);
  table_->setModel(results_);
  table_->setAccessibleName(tr("Results of the study"));
  install_row_copy(*table_);
  table_->setTabKeyNavigation(false);
  new FocusOutline(*table_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(row_height);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  adopt_->setToolTip(tr("Add a run with the selected value"));
}

void StudyView::make_actions() {
  actions_.append(make_action(this, tr("&Study a setting …"),
                              tr("Cycle time and contour error over a range of a setting"),
                              QKeySequence(tr("Ctrl+Shift+T")), [this] { emit attention_wanted(); }));
  actions_.append(make_action(this, tr("Copy the picture of the study"),
                              tr("Copy the curves of the study to the clipboard"), {},
                              [this] { QApplication::clipboard()->setPixmap(chart_->grab()); }));
  actions_.append(
      make_action(this, tr("Save the study as CSV …"), tr("The numbers, one row per run"), {}, [this] {
        if (study_ == nullptr) {
          verdict_->setText(tr("There is no study to save: run one first."));
          return;
        }
        const QString file =
            QFileDialog::getSaveFileName(this, tr("Save the study"), {}, tr("Tables (*.csv)"));
        const std::string text = study_csv(*study_);
        QSaveFile out(file);
        const auto size = static_cast<qint64>(text.size());
        if (!file.isEmpty() &&
            (!out.open(QIODevice::WriteOnly) || out.write(text.data(), size) != size || !out.commit())) {
          verdict_->setText(tr("%1 cannot be written: %2.").arg(file, out.errorString()));
        }
      }));
}

void StudyView::make_layout() {
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 4, 4, 0);
  bar->addWidget(key_);
  for (const auto& [text, field] : {std::pair<QString, QWidget*>{tr("from"), from_}, {tr("to"), to_}}) {
    bar->addWidget(new QLabel(text, this));
    bar->addWidget(field);
  }
  bar->addWidget(count_);
  bar->addWidget(logarithmic_);
  bar->addStretch();
  auto* below = new QHBoxLayout;
  below->setContentsMargins(4, 0, 4, 0);
  below->addWidget(bounded_);
  below->addWidget(bound_);
  below->addWidget(run_);
  below->addWidget(adopt_);
  below->addWidget(progress_, 1);
  below->addStretch();
  verdict_->setContentsMargins(4, 0, 4, 0);
  auto* results = new QSplitter(this);
  results->addWidget(chart_);
  results->addWidget(table_);
  results->setSizes({500, 400});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(bar);
  layout->addLayout(below);
  layout->addWidget(verdict_);
  layout->addWidget(results, 1);
}

/// Lists settings with numbers only: a choice has no range, and an unknown value has none to propose.
void StudyView::list_keys() {
  const SetupState& setup = workbench_.setup().state();
  const QString chosen = key_->currentData().toString();
  const QSignalBlocker quiet(key_);
  key_->clear();
  const std::string axes = axis_names(setup.file().machine);
  for (const std::string& key : sweep_keys(*setup.file().model)) {
    const bool of_absent_axis = key.size() > 2 && key[1] == '.' && axes.find(key[0]) == std::string::npos;
    if (of_absent_axis) {
      continue;
    }
    const bool known = key != tolerance || setup.file().settings.has(setting_of(key));
    if (!known || (key != tolerance && setting_of(tolerance) == key)) {
      continue;
    }
    const SettingSpec spec = setup.spec(setting_of(key));
    const bool of_rotary_axes = is_rotary_setting(key) && setup.file().machine.kinematics.empty();
    const bool has_value =
        !spec.optional || spec.fallback > 0 || setup.value(setting_of(key)) != SettingValue(std::string());
    if (spec.choices.empty() && has_value && !of_rotary_axes) {
      const QString unit = key_unit(sweep_unit(key)).text;
      const QString name = setting_title(key);
      key_->addItem(unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit),
                    QString::fromStdString(key));
      key_->setItemData(key_->count() - 1, QString::fromStdString(key), Qt::ToolTipRole);
    }
  }
  key_->setCurrentIndex(std::max(0, key_->findData(chosen)));
  propose_range();
}

void StudyView::propose_range() {
  const std::string key = key_->currentData().toString().toStdString();
  if (key == tolerance) {
    show_range(0.005, 0.1, tolerance);
    return;
  }
  if (key.empty()) {
    return;
  }
  const SetupState& setup = workbench_.setup().state();
  const SettingSpec spec = setup.spec(key);
  const SettingValue set = setup.value(key);
  const double value = std::holds_alternative<double>(set) ? std::get<double>(set) : spec.fallback;
  constexpr double each_way = 4;
  show_range(nearest_within(spec, value / each_way), nearest_within(spec, value * each_way), key);
}

void StudyView::show_range(double from, double to, const std::string& key) {
  const double factor = key_unit(sweep_unit(key)).factor;
  from_->setValue(from * factor);
  to_->setValue(to * factor);
}

void StudyView::run() {
  if (workbench_.program() == nullptr) {
    verdict_->setText(tr("Open a program first."));
    return;
  }
  const std::string key = key_->currentData().toString().toStdString();
  const double factor = key_unit(sweep_unit(key)).factor;
  try {
    StudyJobRequest request{
        workbench_.shown_program().input, workbench_.runs().setup(workbench_.runs().current_item()),
        rounded(make_sweep(key, from_->value() / factor, to_->value() / factor,
                           static_cast<std::size_t>(count_->value()), logarithmic_->isChecked())),
        bounded_->isChecked() ? std::optional(from_shown_unit(bound_->value(), Dimension::error))
                              : std::nullopt};
    job_.start(request);
    studied_ = workbench_.setup().state();
    studied_name_ = tr("%1 on %2")
                        .arg(run_title(workbench_.runs().current_item(), workbench_.runs().feed_controls(),
                                       key == tolerance ? contour_tolerance_key : key),
                             QString::fromStdString(studied_.file().machine.name));
    forget_results();
  } catch (const InputError& error) {
    verdict_->setText(failure_text(error));
    return;
  }
  progress_->setValue(0);
  progress_->show();
  run_->setText(tr("&Cancel"));
  verdict_->setText(tr("Simulating %1 runs …").arg(count_->value()));
}

/// Discards the results of a previous program.
void StudyView::forget() {
  job_.cancel();
  forget_results();
  if (!busy()) {
    show_idle();
  }
}

void StudyView::forget_results() {
  study_.reset();
  results_->set_study(nullptr);
  chart_->set_study({}, {}, {});
  adopt_->setEnabled(false);
}

void StudyView::follow_traces() {
  if (study_ != nullptr) {
    chart_->set_recorded(recorded_times(workbench_.traces()));
  }
}

void StudyView::take(std::shared_ptr<const Study> study) {
  study_ = std::move(study);
  results_->set_study(study_);
  StudyCurves curves = study_curves(*study_);
  curves.recorded = recorded_times(workbench_.traces());
  chart_->set_study(to_qstring(workbench_.file().filename()), studied_name_, std::move(curves));
  const StudyRun* best = recommended(study_->runs, study_->within);
  if (best != nullptr) {
    table_->selectRow(static_cast<int>(best - study_->runs.data()));
  }
  show_idle();
  verdict_->setText(verdict());
}

QString StudyView::verdict() const {
  if (study_ == nullptr) {
    return tr("Which value of a setting is the fastest, and what contour error does it cause?");
  }
  if (std::ranges::all_of(study_->runs, &StudyRun::refused)) {
    return tr("The control refuses the program: none of its feed motions is run.");
  }
  if (std::ranges::none_of(study_->runs, &StudyRun::is_possible)) {
    return tr("No run is possible: the program sends rotary axes where the machine cannot turn them.");
  }
  const QLocale locale;
  const StudyRun* best = recommended(study_->runs, study_->within);
  if (best == nullptr) {
    return tr("No value keeps the contour error within %1.")
        .arg(amount_text(*study_->within, Dimension::error));
  }
  const QString key = setting_title(study_->sweeps.front().key);
  const QString rest =
      best->lines_not_run == 0
          ? ends_text()
          : tr("Lines that the control refuses and that are not run: %1.").arg(best->lines_not_run) +
                QLatin1Char(' ') + ends_text();
  if (makes_no_difference(study_->runs, study_->within)) {
    return tr("%1 makes no difference to the cycle time: %2 with every value. %3")
        .arg(key, clock_text(best->summary.cycle_time), rest);
  }
  const KeyUnit unit = key_unit(sweep_unit(study_->sweeps.front().key));
  const QString bound = study_->within ? amount_text(*study_->within, Dimension::error) : QString();
  const bool is_fastest =
      best->summary.cycle_time == fastest(study_->runs, study_->within)->summary.cycle_time;
  const QString lead = is_fastest ? (bound.isEmpty() ? tr("Fastest") : tr("Fastest within %1").arg(bound))
                       : bound.isEmpty() ? tr("Recommended")
                                         : tr("Recommended within %1").arg(bound);
  return (best->summary.actual ? tr("%1: %2 %3 with %4, actual contour error %5. %6")
                               : tr("%1: %2 %3 with %4, contour error %5. %6"))
      .arg(lead, key,
           (locale.toString(best->swept.front() * unit.factor, 'g', 5) + ' ' + unit.text).trimmed(),
           clock_text(best->summary.cycle_time), amount_text(deciding_error(best->summary), Dimension::error),
           rest);
}

QString StudyView::ends_text() const {
  const auto end_text = [](const StudyRun& run) {
    return run.is_possible() ? main_cause_text(run.summary) : tr("no possible run");
  };
  QString text = tr("At the first value %1, at the last %2.")
                     .arg(end_text(study_->runs.front()), end_text(study_->runs.back()));
  std::vector<ToleranceRun> runs;
  for (const StudyRun& run : study_->runs) {
    if (run.is_possible()) {
      runs.push_back({&run.setup, &run.summary});
    }
  }
  for (const SlowerTolerance& slower : slower_with_wider_tolerance(runs)) {
    text += QLatin1Char(' ') + slower_tolerance_text(slower);
  }
  return text;
}

void StudyView::make_run(int row) {
  if (study_ == nullptr || row < 0 || row >= static_cast<int>(study_->runs.size())) {
    return;
  }
  const double value = study_->runs[static_cast<std::size_t>(row)].swept.front();
  workbench_.runs().duplicate_as(workbench_.runs().current(),
                                 with_value(studied_, study_->sweeps.front().key, value));
}

void StudyView::show_idle() {
  progress_->hide();
  run_->setText(tr("&Study"));
  adopt_->setEnabled(study_ != nullptr);
  if (study_ == nullptr) {
    verdict_->setText(verdict());
  }
}

}  // namespace feedscope::ui
