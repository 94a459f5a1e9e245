#pragma once

#include <QAction>
#include <QKeySequence>
#include <QString>

namespace feedscope::ui {

/// A command with its text and tooltip; the tooltip includes the key, if any, in the notation of the user's
/// system.
QAction* make_action(QObject* owner, const QString& text, const QString& tip, const QKeySequence& key = {});

/// Everyday words, separated by blanks, for finding a command under another name.
void set_everyday_words(QAction* action, const QString& words);
inline constexpr const char* everyday_words_property = "everyday_words";

/// A command that calls `slot` of `owner` when triggered.
template <typename Owner, typename Slot>
QAction* make_action(Owner* owner, const QString& text, const QString& tip, const QKeySequence& key,
                     Slot slot) {
  QAction* action = make_action(owner, text, tip, key);
  QObject::connect(action, &QAction::triggered, owner, slot);
  return action;
}

}  // namespace feedscope::ui
