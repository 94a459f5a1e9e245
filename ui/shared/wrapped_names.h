#pragma once

#include <QStyledItemDelegate>

class QTreeView;

namespace feedscope::ui {

/// Wraps texts in a column of a tree instead of cutting them: rows are as high as their texts at any column
/// width. A text of more than `most_lines` is cut.
class WrappedNames : public QStyledItemDelegate {
 public:
  static constexpr int most_lines = 3;

  /// For `column` of `tree`, which owns this.
  explicit WrappedNames(QTreeView& tree, int column = 0);

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  QTreeView& tree_;
  int column_;
};

}  // namespace feedscope::ui
