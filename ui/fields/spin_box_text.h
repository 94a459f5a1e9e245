#pragma once

#include <QSpinBox>
#include <QString>
#include <QToolTip>

namespace feedscope::ui {

/// The text typed in a spin box, without its prefix, its suffix and surrounding blanks.
template <typename SpinBox>
QString typed_in(const SpinBox& box, QString text) {
  if (!box.prefix().isEmpty() && text.startsWith(box.prefix())) {
    text.remove(0, box.prefix().size());
  }
  if (!box.suffix().isEmpty() && text.endsWith(box.suffix())) {
    text.chop(box.suffix().size());
  }
  return text.trimmed();
}

/// Shows below a field why it returns to its last value.
inline void say_refused(const QWidget& field, const QString& reason) {
  if (field.isVisible()) {
    QToolTip::showText(field.mapToGlobal(field.rect().bottomLeft()), reason);
  }
}

}  // namespace feedscope::ui
