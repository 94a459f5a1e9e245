// Runs tests that need a QApplication. Each begins as in a process of its own: without settings, in English,
// in the font and colours of the platform.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFont>
#include <QLocale>
#include <QPalette>
#include <QString>
#include <QStyle>

#include "ui/language/language.h"
#include "ui/theme/type_size.h"

namespace {

class FreshStart : public testing::EmptyTestEventListener {
 public:
  void OnTestStart(const testing::TestInfo&) override {
    for (const char* const place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
      QDir(qEnvironmentVariable(place)).removeRecursively();
    }
    feedscope::ui::install_language("en");
    QLocale::setDefault(QLocale::c());
    feedscope::ui::TypeSize::of_application().set_scale(1);
    if (QApplication::font() != font_) {
      QApplication::setFont(font_);
    }
    if (QApplication::palette() != palette_) {
      QApplication::setPalette(palette_);
    }
    if (QApplication::style()->name() != style_) {
      QApplication::setStyle(style_);
    }
  }

 private:
  const QString style_ = QApplication::style()->name();
  const QFont font_ = QApplication::font();
  const QPalette palette_ = QApplication::palette();
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  QLocale::setDefault(QLocale::c());
  const QApplication application(argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new FreshStart);
  return RUN_ALL_TESTS();
}
