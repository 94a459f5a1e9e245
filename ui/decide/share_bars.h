#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <vector>

namespace feedscope::ui {

struct ShareBarRow {
  QString text;
  QString value;
  double share = 0;  ///< of the longest bar, 0 to 1
  QColor colour;
  QString tip;
};

/// Shares of a whole as bars, with names on the left and values on the right. A click requests a row.
class ShareBars : public QWidget {
  Q_OBJECT

 public:
  explicit ShareBars(QWidget* parent = nullptr);

  void set(std::vector<ShareBarRow> rows);
  const std::vector<ShareBarRow>& rows() const { return rows_; }
  QRectF row_place(std::size_t row) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {80, sizeHint().height()}; }

 signals:
  void clicked(std::size_t row);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  int row_height() const;
  std::size_t row_at(const QPointF& place) const;

  std::vector<ShareBarRow> rows_;
};

}  // namespace feedscope::ui
