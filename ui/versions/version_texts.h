#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/analysis/program_difference/program_difference.h"

namespace feedscope::ui {

/// Words for what became of an older program, with the numbers of the user.
class VersionTexts {
  Q_DECLARE_TR_FUNCTIONS(VersionTexts)

 public:
  /// Rich text: cycle time instead of the older one, how much of the path both have.
  static QString conclusion(const Run& old, const Run& now, const ProgramDifference& difference);
  /// "12", "12–40", "–" where there are none.
  static QString lines(const StretchSide& side);
  /// "12.345 s".
  static QString seconds(double time);
  /// "+0.200 s": more time in the new program.
  static QString change(const StretchSide& old, const StretchSide& now);
};

}  // namespace feedscope::ui
