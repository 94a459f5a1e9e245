#include "ui/shared/wrapped_names.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QStyle>
#include <QTreeView>
#include <algorithm>

namespace feedscope::ui {

WrappedNames::WrappedNames(QTreeView& tree, int column)
    : QStyledItemDelegate(&tree), tree_(tree), column_(column) {
  tree_.setWordWrap(true);
  tree_.setItemDelegateForColumn(column_, this);
  connect(tree_.header(), &QHeaderView::sectionResized, this, [this](int section, int before, int now) {
    if (section == column_ && before != now) {
      tree_.doItemsLayout();
    }
  });
}

void WrappedNames::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  option->features |= QStyleOptionViewItem::WrapText;
}

QSize WrappedNames::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  int depth = tree_.rootIsDecorated() ? 1 : 0;
  for (QModelIndex parent = index.parent(); parent.isValid(); parent = parent.parent()) {
    ++depth;
  }
  const int inset = column_ == 0 ? depth * tree_.indentation() : 0;
  const int margin = tree_.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &tree_) + 1;
  const int room = std::max(1, tree_.columnWidth(column_) - inset - 2 * margin);
  const QFontMetrics metrics(item.font);
  const int needed = metrics.boundingRect(0, 0, room, 0, Qt::TextWordWrap, item.text).height();
  const int apart = needed > metrics.height() ? metrics.height() / 3 : 0;  // of the lines of other rows
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  size.setHeight(size.height() - metrics.height() + apart +
                 std::clamp(needed, metrics.height(), most_lines * metrics.height()));
  return size;
}

}  // namespace feedscope::ui
