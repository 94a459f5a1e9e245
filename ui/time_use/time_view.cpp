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

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/time/ruled_instant.h"
#include "core/base/error.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/in_language.h"
#include "ui/language/time_texts.h"
#include "ui/shared/flow_layout.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/shared/wrapped_names.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr int share_role = Qt::UserRole;
constexpr int row_role = Qt::UserRole + 1;  // of TimeRow*

/// Draws a share of the whole as a bar under the text of the second column.
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

TimeView::TimeView(TimeFindings& findings, QWidget* parent)
    : Panel({QStringLiteral("time"), tr("Time"), Qt::RightDockWidgetArea}, parent),
      conclusion_(text_label(this)),
      tree_(new QTreeWidget(this)),
      state_(text_label(this)),
      progress_(new QProgressBar(this)),
      try_(new QPushButton(tr("Try changes"), this)),
      new_run_(new QPushButton(tr("New run with this change"), this)),
      paper_(new QPushButton(tr("Report …"), this)),
      findings_(findings) {
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
                            QKeySequence(tr("Ctrl+Shift+W")), [this] {
                              emit attention_wanted();
                              findings_.try_changes();
                            });
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
  connect(&findings_, &TimeFindings::changed, this, &TimeView::show_sections);
  connect(&findings_, &TimeFindings::state_changed, this, &TimeView::show_state);
  connect(&findings_, &TimeFindings::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(1000 * fraction)); });

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
  show_sections();
  show_state({});
}

void TimeView::follow(Workbench& workbench) {
  connect(this, &TimeView::place_chosen, &workbench, &Workbench::show_place);
  connect(this, &TimeView::time_chosen, &workbench.cursor(), &Cursor::set_time);
  connect(this, &TimeView::run_wanted, &workbench, [&workbench](const SetupState& setup) {
    workbench.runs().duplicate_as(workbench.runs().current(), setup);
  });
}

void TimeView::set_on_screen(bool on_screen) {
  on_screen_ = on_screen;
  watch();
}

void TimeView::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  watch();
}

void TimeView::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  watch();
}

void TimeView::watch() {
  findings_.set_watched(this, on_screen_ && isVisible());
}

void TimeView::show_sections() {
  tree_->clear();
  const auto& shown = findings_.shown();
  const auto& report = findings_.report();
  sections_ = report == nullptr ? std::vector<TimeSection>() : time_sections(*report, shown->run);
  conclusion_->setText(shown == nullptr         ? tr("Open a program to see where its time goes.")
                       : is_refused(shown->run) ? TimeTexts::refusal(shown->run)
                       : !findings_.has_time()  ? TimeTexts::conclusion({}, shown->run)
                       : report != nullptr      ? TimeTexts::conclusion(*report, shown->run)
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
  const bool trying = findings_.trying();
  const bool working = findings_.working();
  progress_->setVisible(working);
  state_->setVisible(!failure.isEmpty() || trying);
  state_->setText(!failure.isEmpty() ? failure : trying ? tr("Simulating what would help …") : QString());
  try_->setVisible(findings_.has_time() && !working && !findings_.tried());
  try_action_->setEnabled(findings_.has_time());
  paper_->setVisible(findings_.report() != nullptr && !working);
  show_actions();
}

void TimeView::show_actions() {
  const TimeRow* row = chosen_row();
  const bool has_run = row != nullptr && row->remedy;
  new_run_->setVisible(findings_.tried());
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
    emit place_chosen(ruled_instant(*findings_.shown()->run.trajectory, *row->place), row->place->from,
                      row->place->to);
  } else if (row->time) {
    emit time_chosen(*row->time);
  }
}

void TimeView::want_run() {
  const TimeRow* row = chosen_row();
  if (row == nullptr || !row->remedy) {
    return;
  }
  try {
    emit run_wanted(findings_.changed_by(*row->remedy));
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

QString TimeView::conclusion() const {
  return QTextDocumentFragment::fromHtml(conclusion_->text()).toPlainText();
}

}  // namespace feedscope::ui
