#include "ui/theme/offscreen_application.h"

#include <QApplication>
#include <QFont>
#include <QLocale>
#include <cstdio>

#include "ui/theme/fonts.h"

namespace feedscope::ui {
namespace {

void print_only_failures(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(message));
  }
}

}  // namespace

OffscreenApplication::OffscreenApplication(ThemeKind theme, double pixel_ratio) {
  QLocale::setDefault(QLocale::c());
  if (QApplication::instance() == nullptr) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (pixel_ratio != 1) {
      qputenv("QT_SCALE_FACTOR", QByteArray::number(pixel_ratio));
    }
    qInstallMessageHandler(print_only_failures);  // the platform warns of what pictures do not need
    application_ = std::make_unique<QApplication>(count_, arguments_);
  }
  apply_theme(theme);
  QFont font = QApplication::font();
  font.setFamily(QStringLiteral("DejaVu Sans"));  // in every package list, as the system's font is not
  QApplication::setFont(without_ligatures(font));
}

OffscreenApplication::~OffscreenApplication() = default;

}  // namespace feedscope::ui
