#pragma once

#include <QAction>

namespace feedscope::test {

/// Whether an action has a tip of its own: without one QAction shows its text.
inline bool has_own_tip(const QAction& action) {
  if (action.menu() != nullptr) {
    return true;  // a menu shows no tip
  }
  QAction plain(action.text());
  plain.setIconText(action.iconText());
  return action.toolTip() != plain.toolTip() && action.toolTip() != action.text();
}

}  // namespace feedscope::test
