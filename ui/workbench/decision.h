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
  QString headline;  ///< the run to take, its gain and contour error, or why none is recommended
  QString rule;      ///< reason for this run
};

class DecisionTexts {
  Q_DECLARE_TR_FUNCTIONS(DecisionTexts)

 public:
  static Decision decision(const RunList& runs);
  /// The decision between several runs with these names; `bound`: on the contour error [mm].
  static Decision decision(std::span<const ComparedRun> runs, const QStringList& names,
                           std::optional<double> bound);
  /// Cycle time of `run` against that of `other`: "−8.2 %"; "–" for the same run, and for runs of different
  /// lines.
  static QString against(const Run& run, const Run& other);
  /// Headline for a single run: its cycle time, what of it is lost against the programmed time, its contour
  /// error.
  static QString single(const Summary& summary);

 private:
  static QString error(const Summary& summary);
  static QString only(OnlyChoice why);
  /// No run of them can be chosen, with any bound.
  static QString none_can(std::span<const ComparedRun> runs);
  static QString without_choice(std::span<const ComparedRun> runs, const QStringList& names,
                                std::optional<double> bound);
};

}  // namespace feedscope::ui
