#include "ui/shared/panel_action.h"

namespace feedscope::ui {

QAction* make_action(QObject* owner, const QString& text, const QString& tip, const QKeySequence& key) {
  auto* action = new QAction(text, owner);
  action->setShortcut(key);
  action->setStatusTip(tip);
  action->setToolTip(
      key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  return action;
}

void set_everyday_words(QAction* action, const QString& words) {
  action->setProperty(everyday_words_property, words);
}

}  // namespace feedscope::ui
