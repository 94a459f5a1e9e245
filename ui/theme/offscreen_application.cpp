#include "ui/theme/offscreen_application.h"

#include <QApplication>
#include <QFont>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QThreadPool>
#include <cstdio>
#include <latch>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "ui/theme/fonts.h"

namespace feedscope::ui {
namespace {

void print_only_failures(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(message));
  }
}

/// Starts Qt's threads for drawing parts of a large picture while there is memory: Qt waits forever for one
/// that it cannot start. Throws std::bad_alloc if that fails.
void start_drawing_threads() {
  QThreadPool& pool = *QThreadPool::globalInstance();
  const int count = pool.maxThreadCount();
  try {
    std::latch all(count + 1);
    std::vector<std::jthread> trial;
    for (int i = 0; i < count; ++i) {
      try {
        trial.emplace_back([&all] { all.arrive_and_wait(); });
      } catch (const std::system_error&) {
        all.count_down(count - i + 1);  // ends those that have started
        throw;
      }
    }
    all.count_down();
  } catch (const std::system_error&) {
    throw std::bad_alloc();
  }
  pool.setExpiryTimeout(-1);
  const auto all = std::make_shared<std::latch>(count + 1);
  for (int i = 0; i < count; ++i) {
    pool.start([all] { all->arrive_and_wait(); });
  }
  all->arrive_and_wait();
#if QT_VERSION >= QT_VERSION_CHECK(6, 5, 0)
  // After Qt 6.4, drawing has its own inaccessible pool. Its threads draw a picture of many lines in parts,
  // and then live for half a minute after each use.
  constexpr int lines_a_part = 64;
  const QSize many_lines(16, 4 * count * lines_a_part);
  QImage source(many_lines, QImage::Format_RGBX8888);
  QImage target(many_lines, QImage::Format_RGB32);
  if (source.isNull() || target.isNull()) {
    throw std::bad_alloc();
  }
  source.fill(Qt::black);
  QPainter(&target).drawImage(QRectF(target.rect()), source);
#endif
}

}  // namespace

OffscreenApplication::OffscreenApplication(ThemeKind theme, double pixel_ratio) {
  QLocale::setDefault(QLocale::c());
  if (QApplication::instance() == nullptr) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (pixel_ratio != 1) {
      qputenv("QT_SCALE_FACTOR", QByteArray::number(pixel_ratio));
    }
    qInstallMessageHandler(print_only_failures);  // the platform warns of things that pictures do not need
    application_ = std::make_unique<QApplication>(count_, arguments_);
    start_drawing_threads();
  }
  apply_theme(theme);
  QFont font = QApplication::font();
  font.setFamily(QStringLiteral("DejaVu Sans"));  // in every package list, unlike the system's font
  QApplication::setFont(without_ligatures(font));
}

OffscreenApplication::~OffscreenApplication() = default;

}  // namespace feedscope::ui
