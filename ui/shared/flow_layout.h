#pragma once

#include <QLayout>
#include <QList>

namespace feedscope::ui {

/// Arranges widgets like words of a text, in as many rows as the width needs, so that none is cut unless it
/// is alone and wider than the whole. Takes part in QWidget::heightForWidth().
class FlowLayout : public QLayout {
 public:
  explicit FlowLayout(QWidget* parent = nullptr) : QLayout(parent) {}
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override { items_.append(item); }
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override { return items_.value(index); }
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return place({0, 0, width, 0}, false); }
  void setGeometry(const QRect& area) override;
  QSize sizeHint() const override;
  QSize minimumSize() const override;

 private:
  /// Height needed for the width of `area`; `move`: whether to move the widgets too.
  int place(const QRect& area, bool move) const;

  QList<QLayoutItem*> items_;
};

}  // namespace feedscope::ui
