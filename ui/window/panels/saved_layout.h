#pragma once

#include <QByteArray>

namespace feedscope::ui {

/// State of QMainWindow::saveState() with a checksum before it, for storage: Qt may crash on a state with a
/// changed byte.
QByteArray with_checksum(const QByteArray& state);
/// The state in a stored layout, including one of an older version without a checksum; empty if it is
/// damaged.
QByteArray checked_state(const QByteArray& layout);

}  // namespace feedscope::ui
