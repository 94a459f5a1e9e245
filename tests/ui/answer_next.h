#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>

namespace feedscope::test {

/// Clicks the button of `role` in the question that is asked next, and counts it.
inline void answer_next(QMessageBox::ButtonRole role, int& asked) {
  QTimer::singleShot(0, [role, &asked] {
    const auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) {
      return;
    }
    ++asked;
    for (QAbstractButton* button : box->buttons()) {
      if (box->buttonRole(button) == role) {
        button->click();
        return;
      }
    }
    ADD_FAILURE() << "no such answer to: " << box->text().toStdString();
  });
}

}  // namespace feedscope::test
