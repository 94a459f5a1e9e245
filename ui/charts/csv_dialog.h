#pragma once

#include <QDialog>

#include "ui/charts/value_fit.h"

class QLabel;
class QRadioButton;

namespace feedscope::ui {

class NumberBox;

/// What a row of an exported table stands for.
enum class CsvRows {
  samples,  ///< equal steps of time
  blocks,   ///< where each block begins
  pixels,   ///< the columns that the charts draw
};

/// Asks what the rows of the table of the visible range are to be, and says how many each choice gives.
class CsvDialog : public QDialog {
  Q_OBJECT

 public:
  /// `range` [s] is exported; `step`: the first proposal [s]; `blocks` and `pixels`: rows of these choices.
  CsvDialog(const Interval& range, double step, std::size_t blocks, std::size_t pixels,
            QWidget* parent = nullptr);

  CsvRows rows() const;
  /// Of CsvRows::samples [s].
  double step() const;

  QRadioButton* choice(CsvRows rows) const;
  NumberBox* step_box() { return step_; }
  QString count_text() const;

 private:
  void count();

  Interval range_;
  std::size_t blocks_;
  std::size_t pixels_;
  QRadioButton* samples_;
  QRadioButton* by_block_;
  QRadioButton* by_pixel_;
  NumberBox* step_;
  QLabel* count_;
};

}  // namespace feedscope::ui
