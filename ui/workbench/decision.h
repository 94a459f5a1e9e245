#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <optional>
#include <span>

#include "core/analysis/study/recommendation.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// The run to take of those with a result, by its row and that of the slowest possible one; none if no run
/// keeps the bound of `runs`.
std::optional<Recommendation> recommended(const RunList& runs);

/// The decision between runs for people, in the sentences of `compare`.
struct Decision {
  QString headline;  ///< the run to take, its gain and contour error; "" without a choice
  QString rule;      ///< reason for this run
};

class DecisionTexts {
  Q_DECLARE_TR_FUNCTIONS(DecisionTexts)

 public:
  static Decision decision(const RunList& runs);
  /// The decision between several runs with these names; `bound`: on the contour error [mm].
  static Decision decision(std::span<const ComparedRun> runs, const QStringList& names,
                           std::optional<double> bound);

 private:
  static QString error(const Summary& summary);
  static QString only(OnlyChoice why);
  static QString none_keeps(std::span<const ComparedRun> runs, const QStringList& names, double bound);
};

}  // namespace feedscope::ui
