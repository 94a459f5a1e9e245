#include "ui/theme/theme.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <cmath>

namespace feedscope::ui {
namespace {

/// How far the pixels of a widget are from its corner's, in all.
double ink(QWidget& widget) {
  widget.adjustSize();
  const QImage image = widget.grab().toImage();
  const auto grey = [&](int x, int y) { return qGray(image.pixel(x, y)); };
  const int ground = grey(image.width() - 6, image.height() / 2);
  double sum = 0;
  for (int y = 4; y < image.height() - 4; ++y) {
    for (int x = 4; x < image.width() - 6; ++x) {
      sum += std::abs(grey(x, y) - ground);
    }
  }
  return sum;
}

class ThemeTest : public testing::TestWithParam<ThemeKind> {
 protected:
  ThemeTest() { apply_theme(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(All, ThemeTest, testing::Values(ThemeKind::light, ThemeKind::dark));

TEST_P(ThemeTest, WhatIsDisabledStandsOutLess) {
  const QString text = QStringLiteral("Simulate again");
  QMenu menu;
  QAction* action = menu.addAction(text);
  const double chosen = ink(menu);
  action->setEnabled(false);
  EXPECT_LT(ink(menu), 0.8 * chosen) << "menu";

  QLabel label(text);
  QPushButton button(text);
  QCheckBox box(text);
  QToolButton tool;
  tool.setText(text);
  for (QWidget* widget : std::initializer_list<QWidget*>{&label, &button, &box, &tool}) {
    const double enabled = ink(*widget);
    widget->setEnabled(false);
    EXPECT_LT(ink(*widget), 0.8 * enabled) << widget->metaObject()->className();
  }
}

}  // namespace
}  // namespace feedscope::ui
