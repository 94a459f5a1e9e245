#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/analysis/difference/program_difference.h"

namespace feedscope::ui {

/// Texts on the changes from an older program, with the numbers of the user.
class VersionTexts {
  Q_DECLARE_TR_FUNCTIONS(VersionTexts)

 public:
  /// Rich text: cycle time and that of the older program, and the common part of the path.
  static QString conclusion(const Run& old, const Run& now, const ProgramDifference& difference);
  /// "12", "12–40", "–" without lines.
  static QString lines(const StretchSide& side);
  /// "12.345 s".
  static QString seconds(double time);
  /// "+0.200 s": more time in the new program.
  static QString change(const StretchSide& old, const StretchSide& now);
};

}  // namespace feedscope::ui
