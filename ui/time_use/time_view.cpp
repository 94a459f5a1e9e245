#include "ui/time_use/time_view.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTextDocumentFragment>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

#include "core/analysis/refused_lines.h"
#include "core/analysis/ruled_instant.h"
#include "core/base/error.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/failure_text.h"
#include "ui/shared/flow_layout.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/shared/wrapped_names.h"
#include "ui/time_use/time_texts.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr double longest_unasked = 5;  // simulation of one run after which changes wait to be asked for [s]
constexpr int pause_ms =
    1200;  // of a run's changes after those of another: values often change again at once
constexpr std::size_t most_known = 16;
constexpr int share_role = Qt::UserRole;
constexpr int row_role = Qt::UserRole + 1;  // of TimeRow*

/// A share of the whole as a bar behind the text of the second column.
class ShareBar : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const double share = std::clamp(index.data(share_role).toDouble(), 0.0, 1.0);
    if (share > 0) {
      QColor colour = option.palette.color(QPalette::Highlight);
      colour.setAlphaF(bar_opacity);
      const QRect rect = option.rect.adjusted(2, 1, -1, -1);
      const int width = std::max(1, static_cast<int>(share * rect.width()));
      painter->fillRect(rect.right() - width + 1, rect.top(), width, rect.height(), colour);
    }
    QStyledItemDelegate::paint(painter, option, index);
  }

 private:
  static constexpr float bar_opacity = 0.25F;
};

QLabel* text_label(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

TimeView::TimeView(QWidget* parent)
    : Panel({QStringLiteral("time"), tr("Time"), Qt::RightDockWidgetArea}, parent),
      conclusion_(text_label(this)),
      tree_(new QTreeWidget(this)),
      state_(text_label(this)),
      progress_(new QProgressBar(this)),
      try_(new QPushButton(tr("Try changes"), this)),
      new_run_(new QPushButton(tr("New run with this change"), this)),
      paper_(new QPushButton(tr("Report …"), this)) {
  tree_->setColumnCount(3);
  tree_->setHeaderHidden(true);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  tree_->setIndentation(12);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setItemDelegateForColumn(1, new ShareBar(tree_));
  new WrappedNames(*tree_);
  tree_->setAccessibleName(tr("Where the time goes"));
  install_row_copy(*tree_);
  new FocusOutline(*tree_);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);

  try_action_ = make_action(this, tr("Where does the time go? Try changes"),
                            tr("Simulate what would help the whole program, each change separately"),
                            QKeySequence(tr("Ctrl+Shift+W")), &TimeView::try_changes);
  run_action_ =
      make_action(this, tr("New run with the chosen change"),
                  tr("Make a run of the change that is chosen under Time"), {}, &TimeView::want_run);
  actions_ = {try_action_, run_action_};
  connect(try_, &QPushButton::clicked, try_action_, &QAction::trigger);
  connect(new_run_, &QPushButton::clicked, run_action_, &QAction::trigger);
  paper_->setToolTip(tr("All of this as a page of a report"));
  connect(paper_, &QPushButton::clicked, this, &TimeView::report_wanted);
  connect(tree_, &QTreeWidget::itemClicked, this, &TimeView::choose);
  connect(tree_, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
    choose(item);
    const TimeRow* row = chosen_row();
    if (row != nullptr && row->remedy) {
      want_run();
    }
  });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &TimeView::show_actions);
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &TimeView::try_wanted);
  connect(&job_, &TimeJob::done, this, &TimeView::take);
  connect(&job_, &TimeJob::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(1000 * fraction)); });
  connect(&job_, &TimeJob::ended, this, [this](const QString& failure) {
    if (!pause_.isActive()) {
      try_wanted();
    }
    show_state(failure);
  });

  state_->setContentsMargins(6, 4, 6, 0);
  auto* buttons = new FlowLayout;
  buttons->setContentsMargins(6, 4, 6, 6);
  buttons->addWidget(try_);
  buttons->addWidget(new_run_);
  buttons->addWidget(paper_);
  conclusion_->setContentsMargins(6, 6, 6, 6);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(conclusion_);
  auto* list = new QHBoxLayout;
  list->setContentsMargins(0, 0, 6, 0);
  list->addWidget(tree_);
  layout->addLayout(list, 1);
  layout->addWidget(progress_);
  layout->addWidget(state_);
  layout->addLayout(buttons);
  show_state({});
}

void TimeView::follow(Workbench& workbench) {
  const auto show_run = [this, &workbench] { set_run(workbench.shown(), workbench.setup().state()); };
  connect(&workbench, &Workbench::run_changed, this, show_run);
  connect(&workbench, &Workbench::busy_changed, this, &TimeView::give_way);
  connect(this, &TimeView::place_chosen, &workbench, &Workbench::show_place);
  connect(this, &TimeView::time_chosen, &workbench.cursor(), &Cursor::set_time);
  connect(this, &TimeView::run_wanted, &workbench, [&workbench](const SetupState& setup) {
    workbench.runs().duplicate_as(workbench.runs().current(), setup);
  });
  show_run();
}

void TimeView::set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup) {
  if (shown == shown_) {
    return;
  }
  const bool follows = shown_ != nullptr;
  cancel();
  shown_ = std::move(shown);
  setup_ = setup;
  report_ = recall();
  tried_ = report_ != nullptr && !report_->changes.tried.empty();
  wanted_ = has_time() && !tried_ && shown_->run.simulate_time < longest_unasked;
  if (wanted_ && follows) {
    pause_.start();
  }
  show_sections();
  stale_ = has_time() && !tried_;
  if (is_seen()) {
    catch_up();
  }
  show_state({});
}

bool TimeView::has_time() const {
  return shown_ != nullptr && !is_refused(shown_->run) && shown_->run.summary.cycle_time > 0;
}

void TimeView::cancel() {
  wanted_ = asked_ = false;
  pause_.stop();
  job_.cancel();
}

void TimeView::set_on_screen(bool on_screen) {
  on_screen_ = on_screen;
  if (is_seen()) {
    catch_up();
  }
}

void TimeView::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  if (is_seen()) {
    catch_up();
  }
}

void TimeView::catch_up() {
  if (!stale_) {
    return;
  }
  if (report_ == nullptr) {
    look();
  } else if (!pause_.isActive()) {
    try_wanted();
  }
}

void TimeView::try_changes() {
  emit attention_wanted();
  if (!has_time()) {
    return;
  }
  pause_.stop();
  wanted_ = asked_ = true;
  if (report_ == nullptr) {
    look();
  } else {
    try_wanted();
  }
}

void TimeView::look() {
  stale_ = false;
  progress_->setValue(0);
  job_.look(shown_);
  show_state({});
}

void TimeView::try_wanted() {
  if (!wanted_ || job_.busy() || (gives_way_ && !asked_) || report_ == nullptr ||
      !(report_->use.cycle_time > 0)) {
    return;
  }
  wanted_ = false;
  progress_->setValue(0);
  job_.try_changes(shown_, report_);
  show_state({});
}

void TimeView::give_way(bool to_others) {
  gives_way_ = to_others;
  if (asked_ || shown_ == nullptr || tried_) {
    return;
  }
  if (to_others && report_ != nullptr && job_.busy()) {
    wanted_ = true;
    job_.cancel();
  } else if (!to_others && wanted_ && report_ != nullptr && !job_.busy()) {
    pause_.start();
  }
}

void TimeView::take(const std::shared_ptr<const TimeReport>& report) {
  report_ = report;
  tried_ = tried_ || !report->changes.tried.empty();
  asked_ = asked_ && !tried_;
  remember(report);
  show_sections();
}

void TimeView::remember(const std::shared_ptr<const TimeReport>& report) {
  std::erase_if(known_, [&](const Known& known) {
    const auto run = known.run.lock();
    return run == nullptr || run == shown_->run.trajectory;
  });
  if (known_.size() == most_known) {
    known_.erase(known_.begin());
  }
  known_.push_back({shown_->run.trajectory, report});
}

std::shared_ptr<const TimeReport> TimeView::recall() const {
  for (const Known& known : known_) {
    if (shown_ != nullptr && known.run.lock() == shown_->run.trajectory) {
      return known.report;
    }
  }
  return nullptr;
}

void TimeView::show_sections() {
  tree_->clear();
  sections_ = report_ == nullptr ? std::vector<TimeSection>() : time_sections(*report_, shown_->run);
  conclusion_->setText(shown_ == nullptr         ? tr("Open a program to see where its time goes.")
                       : is_refused(shown_->run) ? TimeTexts::refusal(shown_->run)
                       : !has_time()             ? TimeTexts::conclusion({}, shown_->run)
                       : report_ != nullptr      ? TimeTexts::conclusion(*report_, shown_->run)
                                                 : tr("Looking where the time goes …"));
  for (const TimeSection& section : sections_) {
    auto* heading = new QTreeWidgetItem(tree_);
    QFont bold = tree_->font();
    bold.setBold(true);
    for (int column = 0; column < 3; ++column) {
      heading->setText(column, section.heading[static_cast<std::size_t>(column)]);
      heading->setFont(column, bold);
      heading->setTextAlignment(column, (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    add_rows(heading, section.rows);
    heading->setExpanded(true);
  }
  show_actions();
}

void TimeView::add_rows(QTreeWidgetItem* parent, const std::vector<TimeRow>& rows) {
  for (const TimeRow& row : rows) {
    auto* item = new QTreeWidgetItem(parent);
    for (int column = 0; column < 3; ++column) {
      const QString& text = row.cells[static_cast<std::size_t>(column)];
      item->setText(column, text);
      item->setToolTip(column, row.tip.isEmpty() ? row.cells[0] : row.cells[0] + QLatin1Char('\n') + row.tip);
      item->setTextAlignment(column, (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    item->setData(1, share_role, row.share);
    item->setData(0, row_role, QVariant::fromValue(static_cast<const void*>(&row)));
    add_rows(item, row.rows);
  }
}

void TimeView::show_state(const QString& failure) {
  const bool trying = job_.busy() && report_ != nullptr;
  progress_->setVisible(job_.busy());
  state_->setVisible(!failure.isEmpty() || trying);
  state_->setText(!failure.isEmpty() ? failure : trying ? tr("Simulating what would help …") : QString());
  try_->setVisible(has_time() && !job_.busy() && !tried_);
  try_action_->setEnabled(has_time());
  paper_->setVisible(report_ != nullptr && !job_.busy());
  show_actions();
}

void TimeView::show_actions() {
  const TimeRow* row = chosen_row();
  const bool has_run = row != nullptr && row->remedy;
  new_run_->setVisible(tried_);
  new_run_->setEnabled(has_run);
  run_action_->setEnabled(has_run);
}

const TimeRow* TimeView::chosen_row() const {
  const QTreeWidgetItem* item = tree_->currentItem();
  return item == nullptr ? nullptr
                         : static_cast<const TimeRow*>(item->data(0, row_role).value<const void*>());
}

void TimeView::choose(const QTreeWidgetItem* item) {
  const auto* row = static_cast<const TimeRow*>(item->data(0, row_role).value<const void*>());
  if (row == nullptr) {
    return;
  }
  if (row->place) {
    emit place_chosen(ruled_instant(*shown_->run.trajectory, *row->place), row->place->from, row->place->to);
  } else if (row->time) {
    emit time_chosen(*row->time);
  }
}

void TimeView::want_run() {
  const TimeRow* row = chosen_row();
  if (row == nullptr || !row->remedy || !setup_) {
    return;
  }
  const Remedy remedy = *row->remedy;  // the run that comes replaces the rows
  SetupState setup = *setup_;
  try {
    if (!remedy.machine.empty()) {
      const Setup changed = with_remedy(setup.setup(), remedy);
      setup =
          SetupState::between(make_setup({remedy.machine, changed.model->info().id, std::nullopt}), changed);
    } else {
      for (const auto& [key, value] : remedy.changes) {
        setup.set(key, value);
      }
    }
  } catch (const InputError& error) {
    emit failed(failure_text(error));
    return;
  }
  emit run_wanted(setup);
}

QString TimeView::conclusion() const {
  return QTextDocumentFragment::fromHtml(conclusion_->text()).toPlainText();
}

}  // namespace feedscope::ui
