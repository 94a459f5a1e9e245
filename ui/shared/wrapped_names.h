#pragma once

#include <QStyledItemDelegate>

class QTreeView;

namespace feedscope::ui {

/// Texts of a column of a tree in as many lines as they need, instead of cut ones: rows are as high as their
/// texts, whenever the column changes its width. A text is cut where `most_lines` do not hold it.
class WrappedNames : public QStyledItemDelegate {
 public:
  static constexpr int most_lines = 3;

  /// Of `column` of `tree`, which owns this.
  explicit WrappedNames(QTreeView& tree, int column = 0);

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  QTreeView& tree_;
  int column_;
};

}  // namespace feedscope::ui
