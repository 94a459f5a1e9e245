// The window in the fonts of usual desktops: no text is cut at the sizes of screens that it supports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QDockWidget>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "core/base/data_folder.h"
#include "tests/ui/patience.h"
#include "tests/ui/report/recorded_text.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/decide/decide_view.h"
#include "ui/decide/tolerance_dialog.h"
#include "ui/language/language.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

using testing::IsEmpty;

struct DesktopFont {
  const char* family;
  std::vector<const char*> files;
  const char* language = "en";
};

void PrintTo(const DesktopFont& font, std::ostream* out) {
  *out << font.family << ' ' << font.language;
}

std::string shown(const QWidget& widget, const QString& text) {
  return QStringLiteral("%1 \"%2\" in %3x%4")
      .arg(widget.metaObject()->className(), text)
      .arg(widget.width())
      .arg(widget.height())
      .toStdString();
}

void add_cut_numbers(const KinematicChart& chart, std::vector<std::string>& cut) {
  feedscope::test::RecordedText paper;
  QPainter painter(&paper);
  chart.draw(painter);
  for (qsizetype i = 0; i < paper.texts().size(); ++i) {
    const feedscope::test::TextSpan& span = paper.spans()[static_cast<std::size_t>(i)];
    if (span.left < 0 || span.right > chart.width()) {
      cut.push_back(shown(chart, paper.texts()[i]));
    }
  }
}

/// Reaches over the edge of the window, where it cannot be scrolled to.
bool is_outside(const QWidget& widget, const QWidget& window) {
  for (const QWidget* around = widget.parentWidget(); around != nullptr; around = around->parentWidget()) {
    if (qobject_cast<const QAbstractScrollArea*>(around) != nullptr) {
      return false;
    }
  }
  return !window.rect().contains(QRect(widget.mapTo(&window, QPoint()), widget.size()));
}

/// Texts of labels, buttons, tabs, rows and axes that do not fit into their places.
std::vector<std::string> cut_texts(const QWidget& window) {
  std::vector<std::string> cut;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->visibleRegion().isEmpty()) {
      continue;
    }
    const QFontMetrics metrics = widget->fontMetrics();
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      const bool fits = label->wordWrap() ? label->height() >= label->heightForWidth(label->width())
                                          : label->height() >= label->minimumSizeHint().height() &&
                                                label->width() >= label->minimumSizeHint().width();
      if (!label->text().isEmpty() && (!fits || is_outside(*label, window))) {
        cut.push_back(shown(*label, label->text()));
      }
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      const auto* tool = qobject_cast<const QToolButton*>(button);
      const bool icon_only =
          tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
      const QString text = QString(button->text()).remove('&');
      if (!text.isEmpty() && !icon_only &&
          (button->height() < metrics.height() || is_outside(*button, window) ||
           button->width() < metrics.size(Qt::TextShowMnemonic, button->text()).width())) {
        cut.push_back(shown(*button, text));
      }
    } else if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
      for (int i = 0; i < tabs->count(); ++i) {
        if (tabs->tabRect(i).width() < metrics.horizontalAdvance(tabs->tabText(i)) ||
            tabs->height() < metrics.height()) {
          cut.push_back(shown(*tabs, tabs->tabText(i)));
        }
      }
    } else if (const auto* header = qobject_cast<const QHeaderView*>(widget)) {
      if (header->orientation() == Qt::Vertical && header->count() > 0 && header->sectionSize(0) > 0 &&
          header->sectionSize(0) < metrics.height()) {
        cut.push_back(shown(*header, "rows"));
      }
      if (header->orientation() == Qt::Horizontal && header->height() < metrics.height()) {
        cut.push_back(shown(*header, "columns"));
      }
    } else if (const auto* chart = qobject_cast<const KinematicChart*>(widget)) {
      add_cut_numbers(*chart, cut);
    }
  }
  return cut;
}

class DesktopFontsTest : public testing::TestWithParam<DesktopFont> {
 protected:
  void SetUp() override {
    for (const char* const file : GetParam().files) {
      if (QFontDatabase::addApplicationFont(file) < 0) {
        GTEST_SKIP() << file << " is not installed";
      }
    }
    QFont font = QApplication::font();
    font.setFamily(GetParam().family);
    QApplication::setFont(font);
    apply_theme();
    install_language(GetParam().language);
  }
  void TearDown() override { install_language("en"); }
};

TEST_P(DesktopFontsTest, NoTextOfTheWindowIsCutOnAnyScreen) {
  Workbench model(shipped_machines(), make_setup({}));
  MainWindow window(model, RenderBackend::software);
  ASSERT_EQ(window.fontInfo().family().toStdString(), GetParam().family);
  window.show();
  const auto program = std::make_shared<const SourceText>(
      SourceText::from_file((data_folder() / "resources/programs/essid_table1.nc").string()));
  model.show(simulate_run(load_program(program), make_setup({})));
  window.part<DecideView>().compare_with(
      ToleranceDialog::setups(model.runs(), QStringLiteral("0.01 0.02 0.05")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy(); }, patience));
  // 1024x768 at 144 dots an inch, and usual ones.
  for (const QSize& screen : {QSize(683, 512), QSize(1280, 800), QSize(1920, 1080), QSize(3840, 2160)}) {
    window.resize(screen);
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      ASSERT_TRUE(QTest::qWaitFor([&] { return !window.busy(); }, patience));
      window.part<ChartsPanel>().refresh();
      for (int i = 0; i < 12; ++i) {
        QApplication::processEvents();
      }
      EXPECT_THAT(cut_texts(window), IsEmpty())
          << dock->objectName().toStdString() << " at " << screen.width() << "x" << screen.height();
    }
  }
}

TEST_P(DesktopFontsTest, NumbersOfTheSmallestChartsAreWhole) {
  const feedscope::Run run = feedscope::test::simulate_text(feedscope::test::small_program);
  Cursor cursor;
  ViewRange range;
  ChartsPanel panel(cursor, range);
  panel.show();
  cursor.set_trajectory(run.trajectory);
  panel.set_limits(run.setup);
  panel.set_run(run.trajectory, std::make_shared<const Envelope>(run.trajectory), false);
  panel.resize(500, panel.minimumSizeHint().height());
  QApplication::processEvents();
  panel.refresh();
  QApplication::processEvents();
  EXPECT_THAT(cut_texts(panel), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Desktops, DesktopFontsTest,
    testing::Values(DesktopFont{"DejaVu Sans", {}}, DesktopFont{"DejaVu Sans", {}, "fr"},
                    DesktopFont{"Noto Sans",
                                {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                 "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"}},
                    DesktopFont{"Cantarell",
                                {"/usr/share/fonts/opentype/cantarell/Cantarell-Regular.otf",
                                 "/usr/share/fonts/opentype/cantarell/Cantarell-Bold.otf"}},
                    DesktopFont{"Liberation Sans",
                                {"/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                                 "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf"}}),
    [](const auto& font) {
      return QString(font.param.family).remove(' ').toStdString() + font.param.language;
    });

}  // namespace
}  // namespace feedscope::ui
