#include "ui/window/panels/saved_layout.h"

#include <QCryptographicHash>

namespace feedscope::ui {

namespace {

const QByteArray mark("layout 1\n");

QByteArray checksum_of(const QByteArray& state) {
  return QCryptographicHash::hash(state, QCryptographicHash::Md5);
}

}  // namespace

QByteArray with_checksum(const QByteArray& state) {
  return mark + checksum_of(state) + state;
}

QByteArray checked_state(const QByteArray& layout) {
  if (!layout.startsWith(mark)) {
    return layout;
  }
  const QByteArray state = layout.mid(mark.size() + checksum_of({}).size());
  return with_checksum(state) == layout ? state : QByteArray();
}

}  // namespace feedscope::ui
