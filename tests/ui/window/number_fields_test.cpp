#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWidgetAction>
#include <cmath>
#include <fstream>
#include <memory>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/csv_dialog.h"
#include "ui/decide/decide_view.h"
#include "ui/fields/number_box.h"
#include "ui/fields/number_text.h"
#include "ui/fields/whole_number_box.h"
#include "ui/program_text/reading_dialog.h"
#include "ui/setup/setup_view.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

/// Types into a line, as a user does who replaces what is in it.
void type(QLineEdit& line, const QString& text) {
  line.setFocus();
  line.selectAll();
  QTest::keyClicks(&line, text);
  QTest::keyClick(&line, Qt::Key_Return);
  QCoreApplication::processEvents();
}

QString with_sign(double number, int decimals, QChar sign) {
  return QString::number(number, 'f', decimals).replace('.', sign);
}

/// Whatever number of the window is typed with a decimal point or a decimal comma, in either language, is
/// that number: every field that there is, also one that comes later.
class NumberFieldsTest : public testing::TestWithParam<const char*> {
 protected:
  NumberFieldsTest() {
    window = std::make_unique<MainWindow>(model, RenderBackend::software);
    window->resize(1280, 800);
    window->show();
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "part.nc";
    std::ofstream(file) << test::small_program;
    model.open(file);
    EXPECT_TRUE(QTest::qWaitFor([this] { return !model.busy(); }, patience));
  }
  ~NumberFieldsTest() override {
    window.reset();
    QLocale::setDefault(before);
  }

  /// Every box for numbers within `widget`; how many there are.
  int walk(const QWidget& widget) {
    int count = 0;
    for (QAbstractSpinBox* box : widget.findChildren<QAbstractSpinBox*>()) {
      SCOPED_TRACE(std::string(box->metaObject()->className()) + " \"" + box->toolTip().toStdString() + "\"");
      box->setEnabled(true);
      auto* line = box->findChild<QLineEdit*>();
      if (auto* number = qobject_cast<NumberBox*>(box)) {
        check(*number, *line);
      } else if (auto* whole = qobject_cast<WholeNumberBox*>(box)) {
        check(*whole, *line);
      } else {
        ADD_FAILURE() << "a field of another kind: use NumberBox or WholeNumberBox";
      }
      ++count;
    }
    return count;
  }
  static void check(NumberBox& box, QLineEdit& line) {
    const double other = box.minimum() + 0.3 * std::min(box.maximum() - box.minimum(), 10.0);
    const int decimals = std::min(box.decimals(), 2);
    for (const double number : {box.minimum() + 0.1 * std::min(box.maximum() - box.minimum(), 1.0), other}) {
      for (const QChar sign : {'.', ','}) {
        box.setValue(box.maximum());
        box.setEnabled(true);  // what follows a value may have locked it again
        type(line, with_sign(number, decimals, sign));
        EXPECT_NEAR(box.value(), with_sign(number, decimals, '.').toDouble(), 1e-9)
            << with_sign(number, decimals, sign).toStdString();
      }
    }
  }
  static void check(WholeNumberBox& box, QLineEdit& line) {
    const int value = box.value();
    for (const char* text : {"1,5", "1.5"}) {
      type(line, text);
      EXPECT_EQ(box.value(), value) << text;
    }
  }

  QLocale before;
  const QTemporaryDir folder;
  bool language_set = [] {
    QLocale::setDefault(QLocale(GetParam()));
    return true;
  }();
  Workbench model{shipped_machines(), make_setup({})};
  std::unique_ptr<MainWindow> window;
};

TEST_P(NumberFieldsTest, EveryBoxOfTheWindowTakesBothSigns) {
  EXPECT_GE(walk(*window), 9);
  int in_menus = 0;
  for (const QWidgetAction* action : window->findChildren<QWidgetAction*>()) {
    in_menus += action->defaultWidget() != nullptr ? walk(*action->defaultWidget()) : 0;
  }
  EXPECT_GE(in_menus, 2);
}

TEST_P(NumberFieldsTest, EveryBoxOfADialogTakesBothSigns) {
  ReadingDialog reading({}, nullptr);
  EXPECT_GE(walk(reading), 2);
  CsvDialog csv({0, 10}, 0.003, 5, 5);
  EXPECT_GE(walk(csv), 1);
}

TEST_P(NumberFieldsTest, EveryNumberOfTheMachineTablesTakesBothSigns) {
  int changed = 0;
  for (QTableView* table : window->part<SetupView>().findChildren<QTableView*>()) {
    QAbstractItemModel& cells = *table->model();
    for (int row = 0; row < cells.rowCount(); ++row) {
      for (int column = 0; column < cells.columnCount(); ++column) {
        const QModelIndex index = cells.index(row, column);
        const auto value = number_of(index.data(Qt::EditRole).toString());
        if (!(cells.flags(index) & Qt::ItemIsEditable) || !value) {
          continue;
        }
        const double other = 0.75 * *value;
        for (const QChar sign : {'.', ','}) {
          QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the editor before
          table->setCurrentIndex(index);
          table->edit(index);
          auto* line = table->viewport()->findChild<QLineEdit*>();
          ASSERT_NE(line, nullptr);
          const int steps = model.setup().history().index();
          type(*line, with_sign(other, 4, sign));
          const double now = number_of(index.data(Qt::EditRole).toString()).value_or(-1);
          // A number that the setting does not take leaves it as it was.
          const bool taken = model.setup().history().index() > steps;
          EXPECT_NEAR(now, taken ? other : *value, 1e-4 * std::abs(*value) + 1e-4)
              << with_sign(other, 4, sign).toStdString();
          if (taken) {
            model.setup().history().undo();
            ++changed;
          }
        }
        EXPECT_EQ(changed % 2, 0) << "one sign was taken and the other one not";
      }
    }
  }
  EXPECT_GE(changed, 30);
}

TEST_P(NumberFieldsTest, TolerancesForNewRunsTakeBothSigns) {
  const std::vector<std::pair<QString, std::array<double, 2>>> typed{
      {QStringLiteral("0.013 0.017"), {0.013, 0.017}}, {QStringLiteral("0,014; 0,018"), {0.014, 0.018}}};
  for (const auto& [text, tolerances] : typed) {
    const std::size_t runs = model.runs().items().size();
    QTimer::singleShot(0, [&text = text] {
      auto* line = QApplication::activeModalWidget()->findChild<QLineEdit*>();
      type(*line, text);
    });
    window->part<DecideView>().compare()->trigger();
    ASSERT_EQ(model.runs().items().size(), runs + 2) << text.toStdString();
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      EXPECT_DOUBLE_EQ(*contour_tolerance(model.runs().items()[runs + i].setup.setup()), tolerances[i]);
    }
  }
}

TEST_P(NumberFieldsTest, AToleranceThatIsNoNumberIsAskedForAgain) {
  QTimer::singleShot(0, [] {
    type(*QApplication::activeModalWidget()->findChild<QLineEdit*>(), QStringLiteral("0.01, 0.02"));
    QTimer::singleShot(0, [] {  // the box comes again, with what was typed and what is wrong with it
      QWidget* box = QApplication::activeModalWidget();
      EXPECT_EQ(box->findChild<QLineEdit*>()->text(), "0.01, 0.02");
      EXPECT_TRUE(box->findChild<QLabel*>()->text().startsWith("“0.01,” "))
          << box->findChild<QLabel*>()->text().toStdString();
      type(*box->findChild<QLineEdit*>(), QStringLiteral("0.01 0.02"));
    });
  });
  window->part<DecideView>().compare()->trigger();
  EXPECT_EQ(model.runs().items().size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Languages, NumberFieldsTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace feedscope::ui
