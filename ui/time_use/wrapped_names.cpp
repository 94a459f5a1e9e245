#include "ui/time_use/wrapped_names.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QStyle>
#include <QTreeView>
#include <algorithm>

namespace feedscope::ui {

WrappedNames::WrappedNames(QTreeView& tree) : QStyledItemDelegate(&tree), tree_(tree) {
  tree_.setWordWrap(true);
  tree_.setItemDelegateForColumn(0, this);
  connect(tree_.header(), &QHeaderView::sectionResized, this, [this](int section, int before, int now) {
    if (section == 0 && before != now) {
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
  int depth = 1;
  for (QModelIndex parent = index.parent(); parent.isValid(); parent = parent.parent()) {
    ++depth;
  }
  const int margin = tree_.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &tree_) + 1;
  const int room = std::max(1, tree_.columnWidth(0) - depth * tree_.indentation() - 2 * margin);
  const QFontMetrics metrics(item.font);
  const int needed = metrics.boundingRect(0, 0, room, 0, Qt::TextWordWrap, item.text).height();
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  size.setHeight(size.height() - metrics.height() +
                 std::clamp(needed, metrics.height(), most_lines * metrics.height()));
  return size;
}

}  // namespace feedscope::ui
