#include "ui/versions/versions_view.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTextDocumentFragment>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/fields/focus_outline.h"
#include "ui/language/core_texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/shared/row_copy.h"
#include "ui/versions/version_texts.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr int line_role = Qt::UserRole;  // first and last line in the open program
constexpr int column_count = 6;
constexpr std::size_t most_places = 100;
constexpr double share_of_reading = 0.3;

void add_row(QTreeWidgetItem& heading, const QStringList& cells, const StretchSide& now) {
  auto* row = new QTreeWidgetItem(&heading, cells);
  for (int column = 1; column < column_count; ++column) {
    row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  if (now.first_line > 0) {
    row->setData(0, line_role, QPoint(static_cast<int>(now.first_line), static_cast<int>(now.last_line)));
  }
}

QTreeWidgetItem& add_heading(QTreeWidget& tree, const QStringList& cells) {
  auto* heading = new QTreeWidgetItem(&tree, cells);
  QFont bold = tree.font();
  bold.setBold(true);
  for (int column = 0; column < column_count; ++column) {
    heading->setFont(column, bold);
    heading->setTextAlignment(column, (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  return *heading;
}

QString title_of(ProgramChange change) {
  return core_text(std::string(program_change_title(change)));
}

}  // namespace

VersionsView::VersionsView(QWidget* parent)
    : Panel({QStringLiteral("versions"), tr("Versions"), Qt::BottomDockWidgetArea, false}, parent),
      conclusion_(new QLabel(this)),
      tree_(new QTreeWidget(this)),
      progress_(new QProgressBar(this)),
      choose_(new QPushButton(tr("Older program …"), this)),
      compare_(make_action(this, tr("Compare with an &older program …"),
                           tr("Which stretches of the program changed, and what they cost or gain"),
                           QKeySequence(tr("Ctrl+Shift+O")), &VersionsView::ask)) {
  set_everyday_words(compare_, tr("version diff old new before after"));
  conclusion_->setWordWrap(true);
  conclusion_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  tree_->setColumnCount(column_count);
  tree_->setHeaderHidden(true);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->setIndentation(12);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setAccessibleName(tr("Differences between two versions of the program"));
  install_row_copy(*tree_);
  new FocusOutline(*tree_);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 6, 6, 6);
  head->addWidget(conclusion_, 1);
  head->addWidget(choose_, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(progress_);
  layout->addWidget(tree_, 1);
  connect(choose_, &QPushButton::clicked, compare_, &QAction::trigger);
  connect(tree_, &QTreeWidget::itemClicked, this, &VersionsView::choose);
  connect(tree_, &QTreeWidget::itemActivated, this, &VersionsView::choose);
  connect(&job_, &JobBase::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(1000 * fraction)); });
  show_state({});
}

void VersionsView::follow(Workbench& workbench) {
  workbench_ = &workbench;
  connect(&workbench, &Workbench::run_changed, this, [this, &workbench] {
    if (workbench.shown() != shown_) {
      shown_ = workbench.shown();
      begin();
    }
  });
  connect(this, &VersionsView::place_chosen, &workbench, &Workbench::show_place);
  shown_ = workbench.shown();
  show_state({});
}

void VersionsView::ask() {
  emit attention_wanted();
  if (workbench_ == nullptr || workbench_->program() == nullptr) {
    return;
  }
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Compare with an older program"), to_qstring(workbench_->file().parent_path()),
      tr("NC programs (*.nc *.ngc *.gcode *.tap *.mpf *.spf *.h *.i *.cnc *.iso *.txt);;All files (*)"));
  if (!file.isEmpty()) {
    compare_with(to_path(file));
  }
}

void VersionsView::compare_with(const std::filesystem::path& older) {
  older_ = older;
  begin();
}

void VersionsView::begin() {
  job_.cancel();
  found_.reset();
  show_found();
  if (shown_ != nullptr && !older_.empty()) {
    progress_->setValue(0);
    job_.start(
        [file = older_, now = shown_, reading = workbench_->reading()](JobControl& control) {
          Progress read(control.progress, share_of_reading);
          Progress simulate(control.progress, 1 - share_of_reading);
          const Setup& setup = now->run.setup;
          const LoadedProgram old = load_program(file, &read, reading_on(reading, setup.machine));
          read.report(1);
          Found found{simulate_run(old, setup, &simulate), {}};
          found.difference = compare_programs(found.old, now->run);
          return found;
        },
        [this](const JobOutcome<Found>& outcome) {
          if (outcome.result) {
            found_ = outcome.result;
          } else {
            older_ = outcome.cancelled() ? older_ : std::filesystem::path();
          }
          show_found();
          show_state(outcome.failure);
        });
  }
  show_state({});
}

void VersionsView::show_state(const QString& failure) {
  progress_->setVisible(job_.busy());
  choose_->setEnabled(shown_ != nullptr);
  conclusion_->setText(!failure.isEmpty() ? failure.toHtmlEscaped()
                       : found_.has_value() && shown_ != nullptr
                           ? VersionTexts::conclusion(found_->old, shown_->run, found_->difference)
                       : job_.busy() ? tr("Simulating the older program …")
                       : shown_ == nullptr
                           ? tr("Open a program to compare an older one with it.")
                           : tr("Choose an older version of this program: both run on the machine, model and "
                                "settings of the current run."));
}

void VersionsView::show_found() {
  tree_->clear();
  if (!found_ || shown_ == nullptr) {
    return;
  }
  add_sums();
  add_places();
  tree_->expandAll();
}

void VersionsView::add_sums() {
  QTreeWidgetItem& heading = add_heading(*tree_, {tr("What became of the path"), tr("Stretches"), QString(),
                                                  tr("Older"), tr("New"), tr("Change")});
  for (std::size_t i = 0; i < program_change_count; ++i) {
    const ProgramDifference::Sum& sum = found_->difference.sums[i];
    if (sum.count > 0) {
      add_row(
          heading,
          {title_of(static_cast<ProgramChange>(i)), QLocale().toString(static_cast<qulonglong>(sum.count)),
           QString(), VersionTexts::seconds(sum.old.time), VersionTexts::seconds(sum.now.time),
           VersionTexts::change(sum.old, sum.now)},
          {});
    }
  }
}

void VersionsView::add_places() {
  const ProgramDifference& difference = found_->difference;
  const std::vector<std::size_t> places = largest_changes(difference, most_places);
  QTreeWidgetItem& heading = add_heading(
      *tree_, {places.empty() ? tr("The times differ nowhere") : tr("Where the times differ most"),
               tr("Older lines"), tr("New lines"), tr("Older"), tr("New"), tr("Change")});
  for (const std::size_t i : places) {
    const ProgramStretch& stretch = difference.stretches[i];
    add_row(heading,
            {title_of(stretch.change), VersionTexts::lines(stretch.old), VersionTexts::lines(stretch.now),
             VersionTexts::seconds(stretch.old.time), VersionTexts::seconds(stretch.now.time),
             VersionTexts::change(stretch.old, stretch.now)},
            stretch.now);
  }
}

void VersionsView::choose(const QTreeWidgetItem* item) {
  const QVariant lines = item->data(0, line_role);
  if (lines.isNull() || shown_ == nullptr) {
    return;
  }
  const Trajectory& trajectory = *shown_->run.trajectory;
  const double from = trajectory.time_of_line(static_cast<std::uint32_t>(lines.toPoint().x()));
  const double to = trajectory.time_of_line(static_cast<std::uint32_t>(lines.toPoint().y()) + 1);
  emit place_chosen(from, from, std::max(from, to));
}

QString VersionsView::conclusion() const {
  return QTextDocumentFragment::fromHtml(conclusion_->text()).toPlainText();
}

}  // namespace feedscope::ui
