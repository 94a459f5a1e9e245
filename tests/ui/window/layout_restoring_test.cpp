#include <gtest/gtest.h>

#include <QDockWidget>
#include <QTest>
#include <random>

#include "ui/window/main_window.h"
#include "ui/window/panels/start_page.h"

namespace feedscope::ui {
namespace {

/// A window of no program, of which only the layout matters.
struct LaidOut {
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};

  void settle() {
    constexpr int turns = 4;
    window.part<StartPage>().hide();  // it covers the panels
    for (int i = 0; i < turns; ++i) {
      QCoreApplication::processEvents();
    }
  }
  void show(const QSize& size, bool maximised) {
    window.resize(size);
    if (maximised) {
      window.setWindowState(Qt::WindowMaximized);
    }
    window.show();
    settle();
  }
  QList<QDockWidget*> docks() const { return window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly); }
  void bring_to_front(const QString& name) {
    auto* dock = window.findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
    settle();
  }
  bool in_front(const QString& name) const {
    const auto* dock = window.findChild<QDockWidget*>(name);  // Qt moves those behind out of the window
    return dock->isVisible() && window.rect().contains(dock->geometry().center());
  }
  bool all_docked() const {
    return std::ranges::all_of(
        docks(), [this](QDockWidget* dock) { return window.dockWidgetArea(dock) != Qt::NoDockWidgetArea; });
  }
};

struct Shape {
  QSize size;
  bool maximised;
};

class LayoutRestoring : public testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(Windows, LayoutRestoring,
                         testing::Values(Shape{{1024, 768}, false}, Shape{{1280, 800}, false},
                                         Shape{{1920, 1080}, false}, Shape{{1280, 800}, true}));

TEST_P(LayoutRestoring, BringsEveryPanelBackToTheFrontInAnotherWindow) {
  std::vector<std::pair<QString, QByteArray>> saved;
  {
    LaidOut before;
    before.show(GetParam().size, GetParam().maximised);
    for (const QDockWidget* dock : before.docks()) {
      before.bring_to_front(dock->objectName());
      saved.emplace_back(dock->objectName(), before.window.saveState());
    }
  }
  ASSERT_GE(saved.size(), 17U);
  LaidOut after;
  after.window.restore_layout(saved.front().second);
  after.show(GetParam().size, GetParam().maximised);
  EXPECT_TRUE(after.in_front(saved.front().first));
  for (const auto& [name, layout] : saved) {
    after.window.restore_layout(layout);
    after.settle();
    EXPECT_TRUE(after.in_front(name)) << name.toStdString();
  }
}

/// What a start with a session does: the layout of the last time, the window, the layout of the session; only
/// then has the window manager made the window as large as the screen.
TEST(LayoutRestoringInTurn, KeepsTheLastOfTwoWhenTheWindowGetsItsSizeLater) {
  QByteArray first;
  QByteArray second;
  {
    LaidOut before;
    before.show({1900, 1000}, false);
    first = before.window.saveState();
    before.bring_to_front("runs");
    before.window.findChild<QDockWidget*>("charts")->setFloating(true);
    before.settle();
    second = before.window.saveState();
  }
  LaidOut after;
  after.window.resize(1280, 800);
  after.window.setWindowState(Qt::WindowMaximized);
  after.window.restore_layout(first);
  after.window.show();
  after.window.restore_layout(second);
  after.window.resize(1900, 1000);
  after.settle();
  EXPECT_TRUE(after.in_front("runs"));
  EXPECT_TRUE(after.window.findChild<QDockWidget*>("charts")->isFloating());
}

TEST(LayoutRestoringInTurn, FallsBackToTheDefaultWhereALayoutCannotBeRead) {
  LaidOut opened;
  opened.show({1280, 800}, false);
  const QByteArray whole = opened.window.layout_to_keep();
  opened.bring_to_front("runs");
  std::mt19937 random(20);
  std::vector<QByteArray> damaged{QByteArray("no layout"), QByteArray(1, '\0')};
  for (int i = 0; i < 200; ++i) {
    damaged.push_back(whole.left(static_cast<int>(random() % static_cast<unsigned>(whole.size()))));
    QByteArray changed = whole;
    changed[static_cast<int>(random() % static_cast<unsigned>(whole.size()))] = static_cast<char>(random());
    damaged.push_back(changed);
  }
  for (const QByteArray& layout : damaged) {
    opened.window.restore_layout(layout);
    opened.settle();
    ASSERT_TRUE(opened.all_docked());
    ASSERT_EQ(opened.window.size(), QSize(1280, 800));
  }
}

TEST(LayoutRestoringInTurn, FallsBackToTheDefaultWhereAPanelIsMissing) {
  LaidOut opened;
  opened.show({1280, 800}, false);
  auto* runs = opened.window.findChild<QDockWidget*>("runs");
  runs->setObjectName("of another version");
  const QByteArray other = opened.window.saveState();
  runs->setObjectName("runs");
  opened.window.restore_layout(other);
  opened.settle();
  EXPECT_TRUE(opened.all_docked());
}

}  // namespace
}  // namespace feedscope::ui
