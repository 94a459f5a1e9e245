// Runs tests that need a QApplication, without a display unless QT_QPA_PLATFORM asks for one. Every process
// has settings of its own: tests of one fixture run beside each other and would otherwise see each other's
// presets and recovered work. What Mesa has compiled for the 3D view is theirs together.
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLocale>
#include <QTemporaryDir>

#include "tests/support/folders.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  const QTemporaryDir settings;
  if (!settings.isValid()) {
    qFatal("no folder for the settings of this test: %s", qPrintable(settings.errorString()));
  }
  for (const char* const place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
    qputenv(place, QFile::encodeName(settings.filePath(place)));
  }
  if (!qEnvironmentVariableIsSet("MESA_SHADER_CACHE_DIR")) {
    qputenv("MESA_SHADER_CACHE_DIR", FEEDSCOPE_BINARY_DIR "/shaders");
  }
  QLocale::setDefault(QLocale::c());
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
