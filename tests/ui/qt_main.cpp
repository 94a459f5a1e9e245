// Runs tests that need a QApplication, without a display unless QT_QPA_PLATFORM asks for one.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  QLocale::setDefault(QLocale::c());
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
