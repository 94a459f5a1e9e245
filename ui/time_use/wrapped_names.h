#pragma once

#include <QStyledItemDelegate>

class QTreeView;

namespace feedscope::ui {

/// Names of a tree in as many lines as its first column needs, instead of cut ones: rows are as high as their
/// names, whenever the column changes its width. A name is cut where `most_lines` do not hold it.
class WrappedNames : public QStyledItemDelegate {
 public:
  static constexpr int most_lines = 3;

  /// Takes the first column of `tree`, which owns this.
  explicit WrappedNames(QTreeView& tree);

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  QTreeView& tree_;
};

}  // namespace feedscope::ui
