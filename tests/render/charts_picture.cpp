#include "tests/render/charts_picture.h"

#include <QApplication>
#include <QImage>
#include <QLocale>

#include "core/models/control_model.h"
#include "ui/charts/charts_panel.h"
#include "ui/theme/theme.h"

namespace feedscope::test {
namespace {

constexpr std::size_t velocity_z = 4;

void use_offscreen_application() {
  static int count = 1;
  static char name[] = "render_case";
  static char* arguments[] = {name, nullptr};
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QLocale::setDefault(QLocale::c());
  static const QApplication application(count, arguments);
  ui::apply_theme(ui::ThemeKind::dark);
  QFont font = QApplication::font();
  font.setFamily(QStringLiteral("DejaVu Sans"));
  QApplication::setFont(font);
}

ui::Picture to_picture(const QImage& image) {
  const auto row = static_cast<std::size_t>(image.width()) * 3;
  ui::Picture picture{{image.width(), image.height()}, {}};
  for (int y = 0; y < image.height(); ++y) {
    const uchar* line = image.constScanLine(y);
    picture.rgb.insert(picture.rgb.end(), line, line + row);
  }
  return picture;
}

}  // namespace

ui::Picture draw_dark_charts(const Run& run, ui::PictureSize size) {
  use_offscreen_application();
  SetupRequest request;
  request.machine = "spinner-mvc850";
  request.model = "cam";
  const Run promised = simulate_run(run.input, make_setup(request));
  ui::Cursor cursor;
  ui::ViewRange range;
  ui::ChartsPanel panel(cursor, range);
  panel.setAttribute(Qt::WA_DontShowOnScreen);
  panel.resize(size.width, size.height);
  panel.show();
  cursor.set_trajectory(run.trajectory);
  panel.set_limits(run.setup);
  panel.set_run(run.trajectory, std::make_shared<const Envelope>(run.trajectory), false);
  panel.set_overlays({{promised.trajectory,
                       std::make_shared<const Envelope>(promised.trajectory),
                       {},
                       QColor(0xff, 0x5c, 0xa8),
                       "promised by CAM",
                       true}});
  panel.show_curve(0, velocity_z, false);
  ui::ChartsState state = panel.state();
  state.abscissa = ui::Abscissa::path_length;
  panel.set_state(state);
  cursor.set_time(0.4 * run.trajectory->duration());
  panel.set_second_cursor(0.6 * run.trajectory->duration());
  QApplication::processEvents();
  panel.refresh();
  QApplication::processEvents();
  return to_picture(panel.grab().toImage().convertToFormat(QImage::Format_RGB888));
}

}  // namespace feedscope::test
