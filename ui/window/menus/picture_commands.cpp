#include "ui/window/menus/picture_commands.h"

#include <QApplication>
#include <QClipboard>
#include <QPainter>

#include "ui/charts/charts_panel.h"
#include "ui/language/texts.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {

namespace {

/// `picture` with a line of text below it, both with `scale` pixels per unit.
QImage captioned(const QImage& picture, const QString& caption, double scale) {
  const QFont font = QApplication::font();
  const QFontMetrics metrics(font);
  const int row = 2 * metrics.height();
  const QSize size = (QSizeF(picture.size()) / scale).toSize();
  QImage whole(QSize(picture.width(), picture.height() + static_cast<int>(row * scale)), picture.format());
  whole.setDevicePixelRatio(scale);
  const QPalette palette = QApplication::palette();
  whole.fill(palette.color(QPalette::Window));
  QPainter painter(&whole);
  painter.drawImage(QRectF(QPointF(), QSizeF(size)), picture);
  painter.setPen(palette.color(QPalette::WindowText));
  painter.setFont(font);
  const QRect place = QRect(0, size.height(), size.width(), row).adjusted(row / 2, 0, -row / 2, 0);
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(caption, Qt::ElideRight, place.width()));
  return whole;
}

}  // namespace

PictureCommands::PictureCommands(MainWindow& window) : QObject(&window), window_(window) {
  struct Entry {
    Part part;
    QString name;
    QString tip;
    QKeySequence key;
  };
  const Entry entries[] = {
      {Part::scene, tr("&3D view"), tr("Copy the 3D view with its annotations to the clipboard"),
       QKeySequence(tr("Ctrl+Shift+P"))},
      {Part::charts, tr("&Charts"), tr("Copy the charts to the clipboard"), {}},
      {Part::window, tr("&Window"), tr("Copy all of the window to the clipboard"), {}}};
  for (const Entry& entry : entries) {
    const Part part = entry.part;
    actions_.append(make_action(this, entry.name, entry.tip, entry.key,
                                [this, part] { QApplication::clipboard()->setImage(picture(part)); }));
  }
}

QImage PictureCommands::picture(Part part) const {
  window_.scenes().rest();
  const double scale = window_.devicePixelRatioF();
  if (part == Part::window) {
    return window_.grab().toImage();
  }
  if (part == Part::charts) {
    return captioned(window_.part<ChartsPanel>().grab().toImage(), caption(), scale);
  }
  SceneView& view = window_.scene();
  view.scene().set_cube(false);
  const QImage scene = view.canvas().grab().toImage();
  view.scene().set_cube(true);
  return captioned(scene, caption(), scale);
}

QString PictureCommands::caption() const {
  Workbench& workbench = window_.workbench();
  const auto shown = workbench.shown();
  if (shown == nullptr) {
    return {};
  }
  const Run& run = shown->run;
  return QStringList{to_qstring(workbench.file().filename()), QString::fromStdString(run.setup.machine.name),
                     workbench.runs().title(workbench.runs().current_item()),
                     clock_text(run.summary.cycle_time)}
      .join(QStringLiteral(" · "));
}

}  // namespace feedscope::ui
