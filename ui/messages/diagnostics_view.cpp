#include "ui/messages/diagnostics_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/fields/focus_outline.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/row_copy.h"
#include "ui/shared/wrapped_names.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

QStyle::StandardPixmap icon_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return QStyle::SP_MessageBoxCritical;
    case Severity::warning:
      return QStyle::SP_MessageBoxWarning;
    case Severity::info:
      break;
  }
  return QStyle::SP_MessageBoxInformation;
}

/// Draws the icons of severities; the model is free of widgets and has none.
class SeverityDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const auto severity = static_cast<Severity>(index.data(DiagnosticsModel::severity_role).toInt());
    option->icon = option->widget->style()->standardIcon(icon_of(severity));
    option->features |= QStyleOptionViewItem::HasDecoration;
    const int side = option->widget->style()->pixelMetric(QStyle::PM_SmallIconSize);
    option->decorationSize = {side, side};
  }
};

}  // namespace

DiagnosticsView::DiagnosticsView(QWidget* parent)
    : Panel({QStringLiteral("messages"), tr("Messages"), Qt::BottomDockWidgetArea, false}, parent),
      model_(new DiagnosticsModel(this)),
      shown_(new DiagnosticsFilter(this)),
      list_(new QTreeView(this)),
      filter_(new QComboBox(this)) {
  shown_->setSourceModel(model_);
  filter_->addItem(tr("All messages"), static_cast<int>(Severity::info));
  filter_->addItem(tr("Warnings and errors"), static_cast<int>(Severity::warning));
  filter_->addItem(tr("Errors"), static_cast<int>(Severity::error));
  filter_->setToolTip(tr("Messages listed and visited by F8"));
  filter_->setAccessibleName(tr("Severity"));
  connect(filter_, &QComboBox::currentIndexChanged, this,
          [this] { shown_->set_least(static_cast<Severity>(filter_->currentData().toInt())); });

  list_->setModel(shown_);
  list_->setRootIsDecorated(false);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setAccessibleName(tr("Messages"));
  list_->setItemDelegateForColumn(DiagnosticsModel::place, new SeverityDelegate(list_));
  list_->header()->setSectionResizeMode(DiagnosticsModel::place, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(DiagnosticsModel::message, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(DiagnosticsModel::hint, QHeaderView::Stretch);
  list_->header()->setStretchLastSection(false);
  new WrappedNames(*list_, DiagnosticsModel::message);
  new WrappedNames(*list_, DiagnosticsModel::hint);
  install_row_copy(*list_);
  new FocusOutline(*list_);
  connect(list_, &QTreeView::clicked, this, &DiagnosticsView::choose);
  connect(list_, &QTreeView::activated, this, &DiagnosticsView::choose);

  add_step(tr("Next message"), tr("Go to the next message of the program"), QKeySequence(Qt::Key_F8), true);
  add_step(tr("Previous message"), tr("Go to the previous message"), QKeySequence(Qt::SHIFT | Qt::Key_F8),
           false);

  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 4, 4, 4);
  bar->addWidget(filter_);
  bar->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(list_, 1);
}

void DiagnosticsView::add_step(const QString& text, const QString& tip, const QKeySequence& key,
                               bool forward) {
  QAction* action = make_action(this, text, tip, key, [this, forward] { step(forward); });
  addAction(action);
  actions_.append(action);
}

void DiagnosticsView::step(bool forward) {
  const int row = shown_->next_row(list_->currentIndex().row(), place_, forward);
  if (row >= 0) {
    const QModelIndex index = shown_->index(row, DiagnosticsModel::place);
    list_->setCurrentIndex(index);
    choose(index);
  }
}

void DiagnosticsView::choose(const QModelIndex& index) {
  const uint line = index.data(DiagnosticsModel::line_role).toUInt();
  if (line > 0) {
    emit place_chosen(line, index.data(DiagnosticsModel::byte_role).toUInt());
  }
}

void DiagnosticsView::follow(Workbench& workbench) {
  connect(&workbench, &Workbench::program_changed, this,
          [this, &workbench] { set_program(workbench.program()); });
  set_program(workbench.program());
}

}  // namespace feedscope::ui
