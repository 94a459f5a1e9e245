#include "ui/window/picture_commands.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QPainter>

#include "ui/charts/chart_export.h"
#include "ui/charts/charts_panel.h"
#include "ui/language/failure_text.h"
#include "ui/report/picture_file.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/window/main_window.h"
#include "ui/window/proposed_file.h"

namespace feedscope::ui {

namespace {

PictureFormat format_of(const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  return ending == "svg" ? PictureFormat::svg : ending == "pdf" ? PictureFormat::pdf : PictureFormat::png;
}

}  // namespace

PictureCommands::PictureCommands(MainWindow& window) : QObject(&window), window_(window) {
  struct Entry {
    Part part;
    QString name;
    QString save_tip;
    QString copy_tip;
    QKeySequence copy_key;
  };
  const Entry entries[] = {
      {Part::scene, tr("&3D view"), tr("Save the 3D view with its annotations as PNG, SVG or PDF"),
       tr("Copy the 3D view with its annotations to the clipboard"), QKeySequence(tr("Ctrl+Shift+P"))},
      {Part::charts,
       tr("&Charts"),
       tr("Save the charts as PNG, SVG or PDF"),
       tr("Copy the charts to the clipboard"),
       {}},
      {Part::window,
       tr("&Window"),
       tr("Save all of the window as PNG, SVG or PDF"),
       tr("Copy all of the window to the clipboard"),
       {}}};
  for (const Entry& entry : entries) {
    const Part part = entry.part;
    save_.append(make_action(this, tr("%1 …").arg(entry.name), entry.save_tip, {},
                             [this, part] { ask_and_save(part); }));
    copy_.append(make_action(this, entry.name, entry.copy_tip, entry.copy_key, [this, part] { copy(part); }));
  }
}

QImage PictureCommands::picture(Part part) const {
  QWidget& shown = part == Part::scene    ? window_.scene().canvas()
                   : part == Part::charts ? static_cast<QWidget&>(window_.part<ChartsPanel>())
                                          : static_cast<QWidget&>(window_);
  window_.scenes().rest();
  return shown.grab().toImage();
}

void PictureCommands::save(Part part, const QString& file) const {
  PictureSpec spec;
  spec.format = format_of(file);
  spec.background = QApplication::palette().color(QPalette::Window);
  spec.title = window_.windowTitle();
  spec.scale = window_.devicePixelRatioF();
  std::string bytes;
  if (part == Part::charts) {
    spec.size = window_.part<ChartsPanel>().size();
    bytes = make_picture(spec, [this](QPainter& painter) { window_.part<ChartsPanel>().draw(painter); });
  } else {
    const QImage image = picture(part);
    spec.size = QSizeF(image.size()) / spec.scale;
    bytes = make_picture(spec,
                         [&](QPainter& painter) { painter.drawImage(QRectF(QPointF(), spec.size), image); });
  }
  write_whole_file(file, QByteArray::fromStdString(bytes));
}

void PictureCommands::copy(Part part) const {
  QApplication::clipboard()->setImage(picture(part));
}

QString PictureCommands::proposed_file(Part part) const {
  const QString what = part == Part::scene    ? QStringLiteral("3d")
                       : part == Part::charts ? QStringLiteral("charts")
                                              : QStringLiteral("window");
  return ui::proposed_file(window_.workbench().file(), what, QStringLiteral("png"));
}

void PictureCommands::ask_and_save(Part part) {
  QString file = QFileDialog::getSaveFileName(&window_, tr("Save picture"), proposed_file(part),
                                              tr("Picture (*.png);;Drawing (*.svg);;Document (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  if (QFileInfo(file).suffix().isEmpty()) {
    file += QStringLiteral(".png");
  }
  try {
    save(part, file);
    emit saved(tr("%1 has been written").arg(QFileInfo(file).fileName()));
  } catch (const std::exception& error) {
    emit failed(failure_text(error));
  }
}

}  // namespace feedscope::ui
