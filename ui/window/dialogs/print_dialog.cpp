#include "ui/window/dialogs/print_dialog.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QPrintDialog>
#include <QPrintPreviewWidget>
#include <QPushButton>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "ui/language/in_language.h"
#include "ui/report/paged_pdf.h"
#include "ui/session/session_file.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/units/unit_system.h"
#include "ui/window/menus/handout_command.h"
#include "ui/window/panels/state_line.h"

namespace feedscope::ui {

namespace {

constexpr QSize usual_print_size(900, 760);
const QString printed_session = QStringLiteral("print.feedscope");
const QString printed_pages = QStringLiteral("pages.feedpages");

/// Adds language and units of the window.
QStringList as_in_window(QStringList command, const QString& language) {
  if (!language.isEmpty()) {
    command.append(QStringLiteral("--language=%1").arg(language));
  }
  if (unit_system() == UnitSystem::inch) {
    command.append(QStringLiteral("--display-units=inch"));
  }
  return command;
}

/// Arguments of `feedscope render` for the session on a sheet of paper.
QStringList render_arguments(const char* view, const QString& language) {
  return as_in_window(
      {QStringLiteral("render"), printed_session, QStringLiteral("--view=%1").arg(QLatin1String(view)),
       QStringLiteral("--size=A4"), QStringLiteral("--theme=light")},
      language);
}

}  // namespace

PrintDialog::PrintDialog(PrintSubject subject, const QString& executable, QWidget* parent)
    : QDialog(parent),
      subject_(std::move(subject)),
      printer_(QPrinter::HighResolution),
      choice_(new QComboBox(this)),
      preview_(new QPrintPreviewWidget(&printer_, this)),
      state_(new StateLine(this)),
      print_(new QPushButton(tr("&Print …"), this)),
      making_(executable, {}) {
  setWindowTitle(tr("Print"));
  printer_.setFullPage(true);
  printer_.setPageSize(QPageSize(QPageSize::A4));
  list_items();
  make_zooms();
  make_layout();
  connect(preview_, &QPrintPreviewWidget::paintRequested, this,
          [this](QPrinter* printer) { pages_.print(*printer); });
  connect(choice_, &QComboBox::currentIndexChanged, this, &PrintDialog::make_pages);
  connect(print_, &QPushButton::clicked, this, &PrintDialog::ask_and_print);
  connect(&making_, &CommandProcess::done, this, &PrintDialog::read_pages);
  connect(&making_, &CommandProcess::failed, state_, &StateLine::say_failure);
  make_pages();
}

void PrintDialog::list_items() {
  if (subject_.session) {
    items_.append({tr("3D view"), render_arguments("3d", subject_.language), {}});
    items_.append({tr("Charts"), render_arguments("charts", subject_.language), {}});
    items_.append({tr("Sheet"), render_arguments("sheet", subject_.language), {}});
    items_.append(
        {tr("Report"), as_in_window({QStringLiteral("report"), printed_session}, subject_.language), {}});
  }
  qsizetype proposed = 0;
  if (subject_.lesson != nullptr) {
    proposed = items_.size();  // in a class, hand-outs are printed most
    for (const auto& [reader, title] : {std::pair(HandoutReader::learners, tr("Hand-out for learners")),
                                        std::pair(HandoutReader::teacher, tr("Hand-out for the teacher")),
                                        std::pair(HandoutReader::everybody, tr("Hand-out for everybody"))}) {
      items_.append(
          {title,
           QStringList{QStringLiteral("lessons")} + HandoutCommand::arguments(*subject_.lesson, reader),
           {}});
    }
  }
  for (const PrintedTable& table : subject_.tables) {
    proposed = table.has_focus ? items_.size() : proposed;
    items_.append({tr("Table: %1").arg(table.title), {}, table});
  }
  for (const Item& item : items_) {
    choice_->addItem(item.title);
  }
  choice_->setCurrentIndex(items_.isEmpty() ? -1 : static_cast<int>(proposed));
}

void PrintDialog::make_zooms() {
  zooms_ = {make_action(this, tr("Page"), tr("Show the page as a whole"), QKeySequence(tr("Ctrl+0")),
                        [this] { preview_->fitInView(); }),
            make_action(this, tr("Width"), tr("Show the page as wide as there is room"), {},
                        [this] { preview_->fitToWidth(); }),
            make_action(this, QStringLiteral("+"), tr("Show the page larger"), QKeySequence::ZoomIn,
                        [this] { preview_->zoomIn(); }),
            make_action(this, QStringLiteral("−"), tr("Show the page smaller"), QKeySequence::ZoomOut,
                        [this] { preview_->zoomOut(); })};
  addActions(zooms_);
}

void PrintDialog::make_layout() {
  auto* what = new QLabel(tr("&What"), this);
  what->setBuddy(choice_);
  choice_->setToolTip(tr("What is printed: as the window shows it now"));
  preview_->setAccessibleName(tr("Preview of the pages"));
  print_->setToolTip(tr("Choose a printer, or a PDF file, and print these pages"));
  print_->setDefault(true);
  auto* close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  auto* above = new QHBoxLayout;
  above->addWidget(what);
  above->addWidget(choice_, 1);
  for (QAction* zoom : zooms_) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(zoom);
    button->setAccessibleName(zoom->toolTip());
    button->setFocusPolicy(Qt::TabFocus);
    above->addWidget(button);
  }
  auto* below = new QHBoxLayout;
  below->addWidget(state_, 1);
  below->addWidget(print_);
  below->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(above);
  layout->addWidget(preview_, 1);
  layout->addLayout(below);
  resize(usual_print_size.boundedTo(screen()->availableSize() - QSize(40, 60)));
}

void PrintDialog::make_pages() {
  making_.cancel();
  show_pages({});
  const int row = choice_->currentIndex();
  if (row < 0) {
    state_->say_failure(tr("There is nothing to print: open a program or a lesson first."));
    return;
  }
  const Item& item = items_[row];
  try {
    if (item.command.isEmpty()) {
      show_pages(recorded_pages(table_page(item.table.title, *item.table.view->model()), ReportPictures(),
                                {item.table.title, {}, {}, tr("page %1 of %2")}));
      return;
    }
    if (subject_.session) {
      write_session(*subject_.session, to_path(QDir(folder_.path()).filePath(printed_session)));
    }
  } catch (const InputError& error) {
    state_->say_failure(failure_text(error));
    return;
  }
  state_->say(tr("Making the pages …"));
  making_.start(item.command + QStringList{QStringLiteral("--out"), printed_pages}, folder_.path());
}

void PrintDialog::read_pages() {
  QFile file(QDir(folder_.path()).filePath(printed_pages));
  try {
    if (!file.open(QIODevice::ReadOnly)) {
      throw InputError(file.errorString().toStdString());
    }
    show_pages(RecordedPages::from_bytes(file.readAll()));
  } catch (const InputError& error) {
    state_->say_failure(failure_text(error));
  }
}

void PrintDialog::show_pages(RecordedPages pages) {
  pages_ = std::move(pages);
  printer_.setDocName(pages_.title());
  printer_.setPageOrientation(pages_.landscape() ? QPageLayout::Landscape : QPageLayout::Portrait);
  print_->setEnabled(pages_.count() > 0);
  state_->say(pages_.count() == 1 ? tr("1 page") : tr("%1 pages").arg(pages_.count()));
  preview_->updatePreview();
}

QString PrintDialog::state() const {
  return state_->text();
}

void PrintDialog::ask_and_print() {
  QPrintDialog dialog(&printer_, this);
  dialog.setMinMax(1, static_cast<int>(std::max<qsizetype>(1, pages_.count())));
  dialog.setOption(QAbstractPrintDialog::PrintPageRange);
  if (dialog.exec() == QDialog::Accepted) {
    print();
  }
}

void PrintDialog::print() {
  pages_.print(printer_);
  if (printer_.printerState() == QPrinter::Error) {
    state_->say_failure(tr("The printer reports an error; nothing was printed."));
    return;
  }
  const QString target =
      printer_.outputFileName().isEmpty() ? printer_.printerName() : printer_.outputFileName();
  emit printed(tr("%1 has been sent to %2").arg(choice_->currentText(), target));
  accept();
}

}  // namespace feedscope::ui
