#include "ui/charts/csv_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QRadioButton>
#include <QVBoxLayout>
#include <cmath>

#include "ui/fields/number_box.h"

namespace feedscope::ui {

namespace {

constexpr double min_step = 1e-6;      // [s]
constexpr double largest_step = 1000;  // [s]

}  // namespace

CsvDialog::CsvDialog(const Interval& range, double step, std::size_t blocks, std::size_t pixels,
                     QWidget* parent)
    : QDialog(parent),
      range_(range),
      blocks_(blocks),
      pixels_(pixels),
      samples_(new QRadioButton(tr("One row every"), this)),
      by_block_(new QRadioButton(tr("One row at the start of each block"), this)),
      by_pixel_(new QRadioButton(tr("One row per pixel of the charts"), this)),
      step_(new NumberBox(this)),
      count_(new QLabel(this)) {
  setWindowTitle(tr("Export visible range"));
  const QLocale locale;
  auto* head = new QLabel(
      tr("From %1 s to %2 s").arg(locale.toString(range.lower, 'f', 3), locale.toString(range.upper, 'f', 3)),
      this);
  step_->setDecimals(6);
  step_->setRange(min_step, largest_step);
  step_->setValue(step);
  step_->setSuffix(tr(" s"));
  step_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  step_->setAccessibleName(tr("Time between rows"));
  samples_->setChecked(true);
  by_pixel_->setToolTip(tr("Values between two pixels are not in the table"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (const QRadioButton* button : {samples_, by_block_, by_pixel_}) {
    connect(button, &QRadioButton::toggled, this, &CsvDialog::count);
  }
  connect(samples_, &QRadioButton::toggled, step_, &QWidget::setEnabled);
  connect(step_, &NumberBox::valueChanged, this, &CsvDialog::count);

  auto* first = new QHBoxLayout;
  first->addWidget(samples_);
  first->addWidget(step_);
  first->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  layout->addLayout(first);
  layout->addWidget(by_block_);
  layout->addWidget(by_pixel_);
  layout->addWidget(count_);
  layout->addWidget(buttons);
  count();
}

CsvRows CsvDialog::rows() const {
  return samples_->isChecked()    ? CsvRows::samples
         : by_block_->isChecked() ? CsvRows::blocks
                                  : CsvRows::pixels;
}

double CsvDialog::step() const {
  return step_->value();
}

QRadioButton* CsvDialog::choice(CsvRows rows) const {
  return rows == CsvRows::samples ? samples_ : rows == CsvRows::blocks ? by_block_ : by_pixel_;
}

QString CsvDialog::count_text() const {
  return count_->text();
}

void CsvDialog::count() {
  const double samples = std::ceil(range_.width() / step_->value() * (1 - 1e-12)) + 1;
  const double count = rows() == CsvRows::samples  ? samples
                       : rows() == CsvRows::blocks ? static_cast<double>(blocks_)
                                                   : static_cast<double>(pixels_);
  count_->setText(tr("%1 rows").arg(QLocale().toString(count, 'f', 0)));
}

}  // namespace feedscope::ui
