#pragma once

#include <QWidget>
#include <memory>

#include "ui/identification/identification_state.h"

class QLabel;
class QTreeWidget;

namespace feedscope::ui {

class ResidualChart;

/// Identification results: the models in the order of their agreement with the recordings; for the chosen one
/// its numbers, identified or not, and its residuals.
class ResultBox : public QWidget {
  Q_OBJECT

 public:
  explicit ResultBox(QWidget* parent = nullptr);

  /// Null for none. The first model explains the recordings best.
  void set_outcome(std::shared_ptr<const IdentificationOutcome> outcome, std::size_t chosen = 0);
  const IdentificationOutcome* outcome() const { return outcome_.get(); }
  /// The result for a session.
  IdentificationResult kept(bool stale) const { return {outcome_, chosen_, stale}; }
  /// The chosen model; null without a result.
  const Identification* chosen() const;
  void choose(std::size_t model);
  /// Whether an input of the result has changed since.
  void set_stale(bool stale);

  QString verdict() const;
  /// Explanation of the selected number.
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
