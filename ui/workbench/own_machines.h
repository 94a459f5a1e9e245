#pragma once

#include <QStringList>

namespace feedscope::ui {

/// The machine files of one's own that were used last, newest first, kept in the user's settings.
class OwnMachines {
 public:
  static constexpr int most = 12;

  /// Those that still exist.
  static QStringList list();
  /// Absolute from here on; a file that is there already moves to the front.
  static void add(const QString& file);
};

}  // namespace feedscope::ui
