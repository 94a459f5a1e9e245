#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <optional>
#include <span>

#include "core/analysis/recommendation.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// The run to take of those that have a result, by its row and that of the slowest one that could be taken;
/// none where no run keeps the bound of `runs`.
std::optional<Recommendation> recommended(const RunList& runs);

/// The decision between runs for people; sentences as those of `compare`.
struct Decision {
  QString headline;  ///< which run to take, what it gains and its contour error; "" where there is no choice
  QString rule;      ///< why this one
};

class DecisionTexts {
  Q_DECLARE_TR_FUNCTIONS(DecisionTexts)

 public:
  static Decision decision(const RunList& runs);
  /// The same of several runs with these names; `bound`: on the contour error [mm].
  static Decision decision(std::span<const ComparedRun> runs, const QStringList& names,
                           std::optional<double> bound);

 private:
  static QString error(const Summary& summary);
  static QString none_keeps(std::span<const ComparedRun> runs, const QStringList& names, double bound);
};

}  // namespace feedscope::ui
