#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTextEdit>
#include <fstream>

#include "tests/ui/locale_in_force.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/study/study_view.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

/// Where the locale has a decimal comma, no number that the window shows has a point.
class DecimalSignsTest : public testing::Test {
 protected:
  DecimalSignsTest() {
    window.resize(1600, 1000);
    window.show();
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "part.nc";
    std::ofstream(file) << test::small_program;
    model.open(file);
    wait();
    model.set_tolerance(0.0125);
    wait();
    model.runs().duplicate(0);
    model.setup().set("X.jerk", 12.5);
    wait();
    model.cursor().set_time(0.37 * model.shown()->run.trajectory->duration());
  }

  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    QCoreApplication::processEvents();
  }

  void check(const QString& text, const QWidget& where) {
    static const QRegularExpression point(QStringLiteral(R"((?<![\w.])\d+\.\d+(?![\w.]))"));
    ++texts;
    EXPECT_FALSE(point.match(text).hasMatch())
        << where.metaObject()->className() << " \"" << where.accessibleName().toStdString()
        << "\": " << text.toStdString();
  }

  void check(const QAbstractItemView& view) {
    const QAbstractItemModel* table = view.model();
    for (int column = 0; table != nullptr && column < table->columnCount(); ++column) {
      check(table->headerData(column, Qt::Horizontal).toString(), view);
      for (int row = 0; row < table->rowCount(); ++row) {
        const QModelIndex index = table->index(row, column);
        check(index.data().toString(), view);
        const QString tip = index.data(Qt::ToolTipRole).toString();
        if (!tip.startsWith(
                QStringLiteral("<p>"))) {  // an explanation: prose, whose numbers translators write
          check(tip, view);
        }
      }
    }
  }

  void check_all() {
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      check(widget->toolTip(), *widget);
      if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        check(label->text(), *label);
      } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
        check(button->text(), *button);
      } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
        check(*view);
      } else if (const auto* text = qobject_cast<const QTextEdit*>(widget)) {
        check(text->toPlainText(), *text);
      } else if (const auto* choice = qobject_cast<const QComboBox*>(widget)) {
        for (int i = 0; i < choice->count(); ++i) {
          check(choice->itemText(i), *choice);
        }
      }
    }
  }

  const test::LocaleInForce french{QLocale(QLocale::French)};
  const QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  int texts = 0;
};

TEST_F(DecimalSignsTest, NoNumberOfThePanelsHasAPoint) {
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    wait();
  }
  window.part<StudyView>().run();
  wait();
  check_all();
  EXPECT_GT(texts, 500);
}

}  // namespace
}  // namespace feedscope::ui
