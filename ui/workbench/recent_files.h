#pragma once

#include <QStringList>

namespace feedscope::ui {

/// The programs opened last, newest first, kept in the user's settings.
class RecentFiles {
 public:
  static constexpr int most = 10;

  /// Those that still exist.
  static QStringList list();
  /// Absolute from here on; a file that is there already moves to the front.
  static void add(const QString& file);
  static void clear();
};

}  // namespace feedscope::ui
