#include "ui/theme/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <vector>

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

/// Qt's own is black in every theme.
TEST_P(ThemeTest, TheButtonForTheRestOfAToolBarIsSeen) {
  QToolBar bar;
  for (int i = 0; i < 8; ++i) {
    bar.addAction(QStringLiteral("A long name"));
  }
  for (const Qt::Orientation orientation : {Qt::Horizontal, Qt::Vertical}) {
    bar.setOrientation(orientation);
    bar.resize(orientation == Qt::Horizontal ? QSize(200, 30) : QSize(90, 90));
    bar.show();
    QCoreApplication::processEvents();
    auto* more = bar.findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    ASSERT_NE(more, nullptr);
    ASSERT_TRUE(more->isVisible());
    const QImage image = more->grab().toImage();
    const int ground = qGray(QApplication::palette().color(QPalette::Window).rgb());
    int strongest = 0;
    for (int y = 1; y < image.height() - 1; ++y) {
      for (int x = 1; x < image.width() - 1; ++x) {
        strongest = std::max(strongest, std::abs(qGray(image.pixel(x, y)) - ground));
      }
    }
    EXPECT_GT(strongest, 90);
  }
}

/// In the corner below a text it reads as a comma.
TEST_P(ThemeTest, TheArrowOfAMenuStandsBesideTheText) {
  QMenu menu;
  QToolButton plain;
  QToolButton opens;
  for (QToolButton* button : {&plain, &opens}) {
    button->setText(QStringLiteral("View"));
    button->setAutoRaise(true);
  }
  opens.setMenu(&menu);
  opens.setPopupMode(QToolButton::InstantPopup);
  plain.adjustSize();
  opens.adjustSize();
  ASSERT_GE(opens.width(), plain.width() + 8);
  const QImage image = opens.grab().toImage();
  int first = image.height();
  int last = 0;
  for (int y = 2; y < image.height() - 2; ++y) {
    for (int x = image.width() - 13; x < image.width() - 3; ++x) {
      if (std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(2, 2))) > 40) {
        first = std::min(first, y);
        last = std::max(last, y);
      }
    }
  }
  EXPECT_NEAR((first + last) / 2.0, image.height() / 2.0, 2.5);
  EXPECT_LE(last - first, 8);
}

/// As if the shorter text were its own.
TEST_P(ThemeTest, ATextTooLongForItsBoxEndsInDots) {
  const QString whole = QStringLiteral("Local smoothing by cubic blends (Sinumerik 840D)");
  QComboBox box;
  box.addItem(whole);
  box.resize(160, box.sizeHint().height());
  const QImage drawn = box.grab().toImage();
  std::vector<QString> same;
  for (int width = 40; width < box.width(); ++width) {
    const QString shorter = box.fontMetrics().elidedText(whole, Qt::ElideRight, width);
    box.setItemText(0, shorter);
    if (box.grab().toImage() == drawn) {
      same.push_back(shorter);
    }
  }
  ASSERT_FALSE(same.empty());
  EXPECT_TRUE(same.front().endsWith(QChar(0x2026))) << same.front().toStdString();
  EXPECT_GT(same.front().size(), 10);
}

/// Time lines are as long as a cycle: a page is no place.
TEST_P(ThemeTest, AClickOnTheGrooveOfASliderGoesThere) {
  QSlider slider(Qt::Horizontal);
  slider.setRange(0, 10000);
  slider.resize(400, 24);
  slider.show();
  for (const int x : {300, 40, 200}) {
    QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(x, 12));
    EXPECT_NEAR(slider.value(), 10000 * x / 400, 300);
  }
}

}  // namespace
}  // namespace feedscope::ui
