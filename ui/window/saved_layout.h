#pragma once

#include <QByteArray>

namespace feedscope::ui {

/// What QMainWindow::saveState() gives with a checksum in front, as it is kept: Qt may crash at a state of
/// which a byte is another one.
QByteArray with_checksum(const QByteArray& state);
/// The state in a layout that was kept, of an older version without a checksum too; empty: it is damaged.
QByteArray checked_state(const QByteArray& layout);

}  // namespace feedscope::ui
