#pragma once

#include <QStringList>

namespace feedscope::ui {

/// The most recently opened programs, newest first, stored in the user's settings.
class RecentFiles {
 public:
  static constexpr int most = 10;

  /// Those that still exist.
  static QStringList list();
  /// Stores an absolute path; a known file moves to the front.
  static void add(const QString& file);
  static void clear();
};

}  // namespace feedscope::ui
