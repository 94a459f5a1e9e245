#pragma once

#include <QDialog>

#include "ui/charts/value_fit.h"

class QLabel;
class QRadioButton;

namespace feedscope::ui {

class NumberBox;

/// Meaning of a row in an exported table.
enum class CsvRows {
  samples,  ///< equal steps of time
  blocks,   ///< the start of each block
  pixels,   ///< the columns of the charts
};

/// Asks for the rows of the exported table and shows their number for each choice.
class CsvDialog : public QDialog {
  Q_OBJECT

 public:
  /// `range` [s] is exported; `step`: the initial value [s]; `blocks` and `pixels`: numbers of rows of these
  /// choices.
  CsvDialog(const Interval& range, double step, std::size_t blocks, std::size_t pixels,
            QWidget* parent = nullptr);

  CsvRows rows() const;
  /// Step of CsvRows::samples [s].
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
