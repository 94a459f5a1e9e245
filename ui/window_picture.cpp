#include "ui/window_picture.h"

#include <QApplication>
#include <QFont>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <cstdio>
#include <memory>

#include "core/base/error.h"
#include "ui/main_window.h"
#include "ui/views/theme.h"

namespace feedscope::ui {

namespace {

void print_only_failures(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(message));
  }
}

/// A QApplication without display, unless the process has one.
class OffscreenApplication {
 public:
  OffscreenApplication() {
    QLocale::setDefault(QLocale::c());
    if (QApplication::instance() == nullptr) {
      qputenv("QT_QPA_PLATFORM", "offscreen");
      qInstallMessageHandler(print_only_failures);  // the platform warns of what pictures do not need
      application_ = std::make_unique<QApplication>(count_, arguments_);
    }
    apply_theme();
    QFont font = QApplication::font();
    font.setFamily(QStringLiteral("DejaVu Sans"));  // in every package list, as the system's font is not
    QApplication::setFont(font);
  }

 private:
  int count_ = 1;
  char name_[10] = "feedscope";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

Picture grab(QWidget& widget, PictureSize size) {
  const QSize least = widget.minimumSizeHint().expandedTo(widget.minimumSize());
  if (size.width < least.width() || size.height < least.height()) {
    const QString message =
        QStringLiteral("a picture of %1 x %2 pixels is too small; it needs at least %3 x %4");
    throw InputError(
        message.arg(size.width).arg(size.height).arg(least.width()).arg(least.height()).toStdString());
  }
  QApplication::processEvents();  // Qt Charts lays its axes out with the next turn of the event loop
  const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(image.width()) * 3;
  Picture picture{{image.width(), image.height()}, {}};
  picture.rgb.reserve(row * static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    const uchar* line = image.constScanLine(y);
    picture.rgb.insert(picture.rgb.end(), line, line + row);
  }
  return picture;
}

QString title_of(const Run& run) {
  const QString file = QString::fromStdString(run.input.program->source->name()).section('/', -1);
  const QString time = QLocale().toString(run.trajectory->duration(), 'f', 3);
  return MainWindow::tr("<b>%1</b> &nbsp; %2 · %3 · %4 s")
      .arg(file.toHtmlEscaped(), QString::fromStdString(run.setup.machine.name).toHtmlEscaped(),
           QString::fromStdString(run.setup.model->info().title).toHtmlEscaped(), time);
}

}  // namespace

Picture draw_window(const Run& run, PictureSize size, StandardView view) {
  const OffscreenApplication application;
  RunModel model(shipped_machines(), run.setup);
  model.show(run);
  MainWindow window(model, RenderBackend::software);
  window.setAttribute(Qt::WA_DontShowOnScreen);
  window.resize(size.width, size.height);
  window.show();
  QApplication::processEvents();
  window.scene().scene().set_standard_view(view);
  window.charts().refresh();
  return grab(window, size);
}

Picture draw_charts(const Run& run, PictureSize size) {
  const OffscreenApplication application;
  QWidget page;
  Cursor cursor;
  auto* title = new QLabel(title_of(run), &page);
  title->setContentsMargins(8, 6, 8, 2);
  title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* charts = new ChartsPanel(cursor, &page);
  charts->hide_controls();
  auto* layout = new QVBoxLayout(&page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(title);
  layout->addWidget(charts, 1);
  charts->set_limits(run.setup.machine.axes);
  charts->set_run(run.trajectory, std::make_shared<const Envelope>(run.trajectory), false);
  page.setAttribute(Qt::WA_DontShowOnScreen);
  page.resize(size.width, size.height);
  page.show();
  QApplication::processEvents();
  charts->refresh();
  return grab(page, size);
}

}  // namespace feedscope::ui
