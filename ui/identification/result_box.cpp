#include "ui/identification/result_box.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/identification/recordings.h"
#include "ui/fields/focus_outline.h"
#include "ui/identification/identification_texts.h"
#include "ui/identification/residual_chart.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/shared/row_copy.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int least_result_rows = 2;
constexpr int most_result_rows = 14;

QTreeWidget* make_table(const QString& name, const QStringList& titles, const QStringList& tips,
                        QWidget* parent) {
  auto* table = new QTreeWidget(parent);
  table->setAccessibleName(name);
  table->setRootIsDecorated(false);
  table->setUniformRowHeights(true);
  table->setAlternatingRowColors(true);
  table->setHeaderLabels(titles);
  for (int column = 0; column < titles.size(); ++column) {
    table->headerItem()->setToolTip(column, tips[column]);
    table->headerItem()->setTextAlignment(column, column == 0 ? Qt::AlignLeft : Qt::AlignRight);
  }
  table->header()->setStretchLastSection(false);
  table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  install_row_copy(*table);
  new FocusOutline(*table);
  return table;
}

void fit_height(QTreeWidget& table) {
  const int rows = std::clamp(table.topLevelItemCount(), least_result_rows, most_result_rows);
  table.setFixedHeight(rows * std::max(1, table.sizeHintForRow(0)) + table.header()->sizeHint().height() +
                       2 * table.frameWidth());
}

QLabel* make_label(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

ResultBox::ResultBox(QWidget* parent)
    : QWidget(parent),
      stale_(make_label(this)),
      verdict_(make_label(this)),
      models_(make_table(tr("Models by how well they explain the recording"),
                         {tr("Model"), tr("Residual"), tr("Feed"), tr("Explains")},
                         {tr("Control model; the one that explains best first"),
                          tr("Root mean square of what the model leaves over; 1 is noise and sampling alone"),
                          tr("Difference of the feeds (rms), as a share of the mean feed"),
                          tr("Within 5 % of the feed and 1 % of the time")},
                         this)),
      parameters_(
          make_table(tr("Numbers that were looked for"), {tr("Number"), tr("Start"), tr("Found")},
                     {tr("Limit of an axis or setting of the control"), tr("Value that was begun with"),
                      tr("Value that explains the recording best, ± 95 %")},
                     this)),
      explanation_(make_label(this)),
      summary_(make_label(this)),
      residuals_(new ResidualChart(this)) {
  stale_->setText(tr("Recordings, models or machine have changed since: identify again."));
  QFont bold = stale_->font();
  bold.setBold(true);
  stale_->setFont(bold);
  stale_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (QWidget* widget : std::initializer_list<QWidget*>{stale_, verdict_, models_, parameters_, explanation_,
                                                         summary_, residuals_}) {
    layout->addWidget(widget);
  }
  connect(models_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    const int row = models_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item));
    if (outcome_ != nullptr && row >= 0 && static_cast<std::size_t>(row) < outcome_->models.size()) {
      chosen_ = static_cast<std::size_t>(row);
      show_chosen();
      emit model_chosen();
    }
  });
  connect(parameters_, &QTreeWidget::currentItemChanged, this, &ResultBox::show_explanation);
  connect(&TypeSize::of_application(), &TypeSize::changed, this, [this] {
    QMetaObject::invokeMethod(
        this,
        [this] {
          fit_height(*models_);
          fit_height(*parameters_);
        },
        Qt::QueuedConnection);
  });
  set_outcome(nullptr);
}

void ResultBox::set_outcome(std::shared_ptr<const IdentificationOutcome> outcome, std::size_t chosen) {
  outcome_ = std::move(outcome);
  chosen_ = outcome_ != nullptr && chosen < outcome_->models.size() ? chosen : 0;
  stale_->hide();
  show_models();
  show_chosen();
}

const Identification* ResultBox::chosen() const {
  return outcome_ == nullptr ? nullptr : &outcome_->models[chosen_];
}

void ResultBox::choose(std::size_t model) {
  models_->setCurrentItem(models_->topLevelItem(static_cast<int>(model)));
}

void ResultBox::set_stale(bool stale) {
  stale_->setVisible(stale && outcome_ != nullptr);
  parameters_->setEnabled(!stale);
  models_->setEnabled(!stale);
}

void ResultBox::show_models() {
  const QSignalBlocker quiet(models_);
  models_->clear();
  models_->setVisible(outcome_ != nullptr && outcome_->models.size() + outcome_->unfitted.size() > 1);
  if (outcome_ == nullptr) {
    return;
  }
  const QLocale locale;
  for (const Identification& found : outcome_->models) {
    auto* row = new QTreeWidgetItem(
        models_, {core_text(found.setup.model->info().title), locale.toString(found.residual, 'f', 2),
                  tr("%1 %").arg(locale.toString(100 * found.feed_error, 'f', 2)),
                  explains_roughly(found, outcome_->models.front()) ? tr("roughly")
                  : found.explains                                  ? tr("yes")
                                                                    : tr("no")});
    row->setToolTip(0, row->text(0));
    for (int column = 1; column < row->columnCount(); ++column) {
      row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  for (const UnfittedModel& unfitted : outcome_->unfitted) {
    auto* row = new QTreeWidgetItem(models_, {core_text(unfitted.title), {}, {}, tr("failed")});
    row->setToolTip(0, in_language(unfitted.reason));
  }
  models_->setCurrentItem(models_->topLevelItem(static_cast<int>(chosen_)));
  fit_height(*models_);
}

void ResultBox::show_chosen() {
  const QSignalBlocker quiet(parameters_);
  parameters_->clear();
  const Identification* found = chosen();
  parameters_->setVisible(found != nullptr);
  verdict_->setVisible(found != nullptr);
  summary_->setVisible(found != nullptr && found->explains);
  residuals_->set_outcome(outcome_, chosen_);
  if (found == nullptr) {
    explanation_->hide();
    return;
  }
  for (const IdentifiedParameter& one : found->parameters) {
    auto* row = new QTreeWidgetItem(
        parameters_, {IdentificationTexts::title(one.parameter),
                      IdentificationTexts::value(one.start, one.parameter), IdentificationTexts::found(one)});
    QFont font = row->font(2);
    font.setBold(one.told);
    row->setFont(2, font);
    for (int column = 0; column < row->columnCount(); ++column) {
      row->setToolTip(column, IdentificationTexts::explanation(one, found->explains));
      row->setTextAlignment(column, (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
  }
  parameters_->setCurrentItem(parameters_->topLevelItem(0));
  fit_height(*parameters_);
  QString verdict = IdentificationTexts::judgement(*found);
  if (!found->explains) {
    verdict += ' ' + tr("Tick other models in step 2.");
  }
  verdict_->setText((QStringList{verdict} + IdentificationTexts::agreements(*outcome_, *found) +
                     IdentificationTexts::drives(*found))
                        .join('\n'));
  summary_->setText(IdentificationTexts::summary(*found));
  show_explanation();
}

void ResultBox::show_explanation() {
  const Identification* found = chosen();
  const int row = parameters_->indexOfTopLevelItem(parameters_->currentItem());
  explanation_->setVisible(found != nullptr && row >= 0);
  if (found != nullptr && row >= 0) {
    const IdentifiedParameter& one = found->parameters[static_cast<std::size_t>(row)];
    explanation_->setText(tr("%1: %2").arg(IdentificationTexts::title(one.parameter),
                                           IdentificationTexts::explanation(one, found->explains)));
  }
}

QString ResultBox::verdict() const {
  return verdict_->text();
}

QString ResultBox::explanation() const {
  return explanation_->text();
}

}  // namespace feedscope::ui
