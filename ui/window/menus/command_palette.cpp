#include "ui/window/menus/command_palette.h"

#include <QDockWidget>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr int palette_width = 560;
constexpr int palette_height = 360;
constexpr QSize key_list_size(640, 640);
constexpr int row_height = 22;

QTableView* make_list(QAbstractItemModel* model, QWidget* parent) {
  auto* list = new QTableView(parent);
  list->setModel(model);
  list->setSelectionBehavior(QAbstractItemView::SelectRows);
  list->setSelectionMode(QAbstractItemView::SingleSelection);
  list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list->setShowGrid(false);
  list->setFrameShape(QFrame::NoFrame);
  list->verticalHeader()->hide();
  list->verticalHeader()->setDefaultSectionSize(row_height);
  list->setTextElideMode(Qt::ElideMiddle);
  list->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list->horizontalHeader()->setSectionResizeMode(ActionTable::place, QHeaderView::Interactive);
  list->horizontalHeader()->setSectionResizeMode(ActionTable::name, QHeaderView::Stretch);
  return list;
}

/// Limits the column of menus: the user searches for names.
void fit_places(QTableView& list, int width) {
  constexpr double largest_share = 0.28;
  list.resizeColumnToContents(ActionTable::place);
  list.setColumnWidth(ActionTable::place, std::min(list.columnWidth(ActionTable::place),
                                                   static_cast<int>(largest_share * width)));
}

/// Matches rows with all words, in any order, in menu, name or description.
QRegularExpression all_words(const QString& words) {
  QString pattern;
  for (const QString& word : words.split(' ', Qt::SkipEmptyParts)) {
    pattern += QStringLiteral("(?=.*%1)").arg(QRegularExpression::escape(word));
  }
  return QRegularExpression(pattern, QRegularExpression::CaseInsensitiveOption);
}

/// Filters by menu, name, tooltip and everyday words together; matches in menu or name come first, otherwise
/// in menu order.
class Found : public QSortFilterProxyModel {
 public:
  explicit Found(QObject* parent) : QSortFilterProxyModel(parent) { sort(0); }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const QModelIndex name = sourceModel()->index(row, ActionTable::name, parent);
    return filterRegularExpression()
        .match(called(row, parent) + ' ' + name.data(Qt::ToolTipRole).toString() + ' ' +
               name.data(ActionTable::words_role).toString())
        .hasMatch();
  }
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
    const auto rank = [this](const QModelIndex& index) {
      return filterRegularExpression().match(called(index.row(), index.parent())).hasMatch() ? 0 : 1;
    };
    return std::pair(rank(left), left.row()) < std::pair(rank(right), right.row());
  }

 private:
  QString called(int row, const QModelIndex& parent) const {
    const auto text = [&](int column) { return sourceModel()->index(row, column, parent).data().toString(); };
    return text(ActionTable::place) + ' ' + text(ActionTable::name);
  }
};

}  // namespace

CommandPalette::CommandPalette(QWidget* window)
    : QFrame(window, Qt::Popup),
      actions_(new ActionTable(this)),
      found_(new Found(this)),
      input_(new QLineEdit(this)),
      list_(nullptr) {
  found_->setSourceModel(actions_);
  list_ = make_list(found_, this);
  list_->horizontalHeader()->hide();
  list_->setFocusPolicy(Qt::NoFocus);
  setFrameShape(QFrame::StyledPanel);
  input_->setPlaceholderText(tr("Find a command"));
  input_->setAccessibleName(tr("Find a command"));
  input_->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(input_);
  layout->addWidget(list_);
  connect(input_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(list_, &QTableView::clicked, this, &CommandPalette::run);
}

void CommandPalette::ask(QList<ListedAction> actions) {
  actions.removeIf([](const ListedAction& listed) { return !listed.action->isEnabled(); });
  actions_->set_actions(std::move(actions));
  input_->clear();
  filter({});
  const QRect around = parentWidget()->rect();
  const int width = std::min(palette_width, around.width());
  resize(width, std::min(palette_height, around.height()));
  fit_places(*list_, width);
  move(parentWidget()->mapToGlobal(QPoint((around.width() - width) / 2, around.height() / 8)));
  show();
  input_->setFocus();
}

void CommandPalette::filter(const QString& words) {
  found_->setFilterRegularExpression(all_words(words));
  found_->invalidate();
  list_->selectRow(0);
}

void CommandPalette::run() {
  QAction* action = actions_->action(found_->mapToSource(list_->currentIndex()));
  hide();
  if (action == nullptr) {
    return;
  }
  // A panel that is searched for comes to the front, where its menu entry would close it.
  if (auto* panel = qobject_cast<QDockWidget*>(action->parent());
      panel != nullptr && panel->toggleViewAction() == action) {
    panel->show();
    panel->raise();
    return;
  }
  action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int row = list_->currentIndex().row();
    switch (key) {
      case Qt::Key_Up:
        list_->selectRow(std::max(0, row - 1));
        return true;
      case Qt::Key_Down:
        list_->selectRow(std::min(found_->rowCount() - 1, row + 1));
        return true;
      case Qt::Key_Return:
      case Qt::Key_Enter:
        run();
        return true;
      default:
        break;
    }
  }
  return QFrame::eventFilter(watched, event);
}

KeyList::KeyList(QWidget* window)
    : QWidget(window, Qt::Tool), actions_(new ActionTable(this)), list_(make_list(actions_, this)) {
  setWindowTitle(tr("Keyboard and mouse"));
  auto* mouse = new QLabel(
      tr("<b>3D view:</b> left drag rotates, Shift+drag or middle drag pans, wheel or right drag zooms, a "
         "click sets the cursor.<br><b>Charts:</b> wheel zooms at the pointer, drag pans, a click sets the "
         "cursor, a double click shows all.<br><b>Program:</b> a click on a line sets the cursor there."),
      this);
  mouse->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(list_);
  layout->addWidget(mouse);
  resize(key_list_size);
}

void KeyList::show_keys(QList<ListedAction> actions) {
  actions.removeIf([](const ListedAction& listed) { return listed.action->shortcuts().isEmpty(); });
  actions_->set_actions(std::move(actions));
  fit_places(*list_, width());
  if (!isVisible()) {
    move(parentWidget()->frameGeometry().center() - rect().center());
  }
  show();
  raise();
  activateWindow();
}

/// Keeps Esc from the window's own command.
bool KeyList::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Cancel)) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void KeyList::keyPressEvent(QKeyEvent* event) {
  event->matches(QKeySequence::Cancel) ? static_cast<void>(close()) : QWidget::keyPressEvent(event);
}

}  // namespace feedscope::ui
