#pragma once

#include <QWidget>
#include <memory>

#include "ui/identification/identification_state.h"

class QLabel;
class QTreeWidget;

namespace feedscope::ui {

class ResidualChart;

/// What was identified: the models by how well they explain the recordings, and of the chosen one its numbers
/// with what is and what is not told, and what it leaves over of the recordings.
class ResultBox : public QWidget {
  Q_OBJECT

 public:
  explicit ResultBox(QWidget* parent = nullptr);

  /// Null for none. The first model is the one that explains best.
  void set_outcome(std::shared_ptr<const IdentificationOutcome> outcome, std::size_t chosen = 0);
  const IdentificationOutcome* outcome() const { return outcome_.get(); }
  /// As a session keeps it.
  IdentificationResult kept(bool stale) const { return {outcome_, chosen_, stale}; }
  /// The model that is chosen; null without a result.
  const Identification* chosen() const;
  void choose(std::size_t model);
  /// Something that it is of has changed since.
  void set_stale(bool stale);

  QString verdict() const;
  /// Of the number that is selected.
  QString explanation() const;
  QTreeWidget& models() { return *models_; }
  QTreeWidget& parameters() { return *parameters_; }
  ResidualChart& residuals() { return *residuals_; }

 signals:
  void model_chosen();

 private:
  void show_models();
  void show_chosen();
  void show_explanation();

  std::shared_ptr<const IdentificationOutcome> outcome_;
  std::size_t chosen_ = 0;
  QLabel* stale_;
  QLabel* verdict_;
  QTreeWidget* models_;
  QTreeWidget* parameters_;
  QLabel* explanation_;
  QLabel* summary_;
  ResidualChart* residuals_;
};

}  // namespace feedscope::ui
