#pragma once

#include <QStringList>

namespace feedscope::ui {

/// The user's most recent machine files, newest first, stored in the user's settings.
class OwnMachines {
 public:
  static constexpr int most = 12;

  /// Those that still exist.
  static QStringList list();
  /// Stores an absolute path; a known file moves to the front.
  static void add(const QString& file);
};

}  // namespace feedscope::ui
