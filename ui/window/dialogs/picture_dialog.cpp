#include "ui/window/dialogs/picture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "core/base/error.h"
#include "ui/fields/number_box.h"
#include "ui/fields/whole_number_box.h"
#include "ui/language/in_language.h"
#include "ui/session/session_file.h"
#include "ui/shared/paths.h"
#include "ui/window/dialogs/language_box.h"
#include "ui/window/dialogs/page_preview.h"
#include "ui/window/dialogs/proposed_file.h"

namespace feedscope::ui {

namespace {

constexpr QSize picture_dialog_size(1060, 640);
constexpr int picture_form_width = 340;
constexpr int pause_before_picture = 500;  // [ms] after the last change
constexpr int picture_preview_dpi = 96;
const QStringList render_command{QStringLiteral("render")};
const QString picture_session = QStringLiteral("picture.feedscope");
const QString preview_name = QStringLiteral("preview.png");

QString size_text(const QSize& size) {
  return QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
}

void choose_data(QComboBox& box, const QString& key) {
  box.setCurrentIndex(std::max(0, box.findData(key)));
}

}  // namespace

PictureDialog::PictureDialog(Subject subject, const QString& executable, QWidget* parent)
    : QDialog(parent),
      subject_(std::move(subject)),
      view_(new QComboBox(this)),
      format_(new QComboBox(this)),
      size_(new QComboBox(this)),
      dpi_(new WholeNumberBox(this)),
      scale_(new NumberBox(this)),
      theme_(new QComboBox(this)),
      language_(new LanguageBox(this)),
      transparent_(new QCheckBox(tr("&Without a background"), this)),
      preview_(new PagePreview(this)),
      state_(new StateLine(this)),
      save_(new QPushButton(tr("&Save picture …"), this)),
      previewing_(executable, render_command),
      saving_(executable, render_command, *state_) {
  setWindowTitle(tr("Picture"));
  auto* close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(state_, 1);
  buttons->addWidget(save_);
  buttons->addWidget(close);
  auto* halves = new QHBoxLayout;
  halves->addWidget(make_form());
  halves->addWidget(preview_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(halves, 1);
  layout->addLayout(buttons);
  resize(picture_dialog_size.boundedTo(screen()->availableSize() - QSize(40, 60)));

  changed_.setSingleShot(true);
  changed_.setInterval(pause_before_picture);
  const auto change = [this] {
    follow_view();
    changed_.start();
  };
  for (QComboBox* box : std::initializer_list<QComboBox*>{view_, format_, size_, theme_, language_}) {
    connect(box, &QComboBox::currentTextChanged, this, change);
  }
  connect(view_, &QComboBox::currentIndexChanged, this, &PictureDialog::list_sizes);
  connect(dpi_, &WholeNumberBox::valueChanged, this, change);
  connect(scale_, &NumberBox::valueChanged, this, change);
  connect(transparent_, &QCheckBox::toggled, this, change);
  connect(&changed_, &QTimer::timeout, this, &PictureDialog::make_preview);
  connect(save_, &QPushButton::clicked, this, &PictureDialog::ask_and_save);
  connect(&previewing_, &CommandProcess::done, this, &PictureDialog::show_preview);
  connect(&previewing_, &CommandProcess::failed, state_, &StateLine::say_failure);
  connect(&saving_, &FileWriting::ended, this, [this] { save_->setEnabled(true); });
  connect(&saving_, &FileWriting::saved, this, &PictureDialog::saved);
  try {
    write_session(subject_.session, to_path(QDir(folder_.path()).filePath(picture_session)));
    make_preview();
  } catch (const InputError& error) {
    state_->say_failure(failure_text(error));
  }
}

PictureDialog::~PictureDialog() {
  remember();
}

QWidget* PictureDialog::make_form() {
  view_->addItem(tr("3D view"), QStringLiteral("3d"));
  view_->addItem(tr("Charts"), QStringLiteral("charts"));
  view_->addItem(tr("Sheet: 3D view, charts and figures"), QStringLiteral("sheet"));
  view_->addItem(tr("The whole window"), QStringLiteral("window"));
  format_->addItem(tr("PNG: bitmap"), QStringLiteral("png"));
  format_->addItem(tr("SVG: drawing"), QStringLiteral("svg"));
  format_->addItem(tr("PDF: document"), QStringLiteral("pdf"));
  theme_->addItem(tr("as in the window"), QString());
  theme_->addItem(tr("light"), QStringLiteral("light"));
  theme_->addItem(tr("dark"), QStringLiteral("dark"));
  size_->setEditable(true);
  size_->setInsertPolicy(QComboBox::NoInsert);
  size_->setToolTip(tr("Pixels, such as 1920x1080, or a sheet of paper: A2 to A6, Letter, A4-portrait"));
  constexpr int coarsest = 36;
  constexpr int finest = 1200;
  dpi_->setRange(coarsest, finest);
  dpi_->setToolTip(tr("Of paper, and of bitmaps in SVG and PDF; a PNG of so many pixels has none"));
  constexpr double smallest = 0.25;
  constexpr double largest = 8;
  scale_->setRange(smallest, largest);
  scale_->setDecimals(2);
  scale_->setSingleStep(smallest);
  scale_->setToolTip(tr("How much larger text and lines are; 1 suits 96 pixels an inch"));
  auto* form = new QWidget(this);
  form->setFixedWidth(picture_form_width);
  auto* fields = new QFormLayout(form);
  fields->setContentsMargins(0, 0, 0, 0);
  fields->addRow(tr("&What"), view_);
  fields->addRow(tr("&Format"), format_);
  fields->addRow(tr("Si&ze"), size_);
  fields->addRow(tr("&Dots an inch"), dpi_);
  fields->addRow(tr("&Text and lines ×"), scale_);
  fields->addRow(tr("&Colours"), theme_);
  fields->addRow(tr("&Language"), language_);
  fields->addRow(QString(), transparent_);
  const QSettings settings;
  const PictureWish usual;
  PictureWish wish;
  wish.view = settings.value("picture/view", usual.view).toString();
  wish.format = settings.value("picture/format", usual.format).toString();
  wish.dpi = settings.value("picture/dpi", usual.dpi).toInt();
  wish.scale = settings.value("picture/scale", subject_.text_scale).toDouble();
  wish.theme = settings.value("picture/theme").toString();
  wish.transparent = settings.value("picture/transparent").toBool();
  choose(wish);
  const QString size = settings.value("picture/size").toString();
  if (!size.isEmpty()) {
    size_->setEditText(size);
  }
  return form;
}

/// Lists sizes suitable for the view, that of the window first.
void PictureDialog::list_sizes() {
  const QString view = view_->currentData().toString();
  const QSize shown = view == QStringLiteral("charts")   ? subject_.charts
                      : view == QStringLiteral("window") ? subject_.window
                                                         : subject_.scene;
  QStringList sizes;
  if (view != QStringLiteral("sheet")) {
    sizes << size_text(shown);
  }
  sizes << QStringLiteral("A4") << QStringLiteral("A4-portrait") << QStringLiteral("A3")
        << QStringLiteral("Letter") << QStringLiteral("1280x960") << QStringLiteral("1920x1080")
        << QStringLiteral("3840x2160");
  const QString before = size_->currentText();
  const bool fits = sizes.contains(before) && size_->findText(before) != 0;
  const QSignalBlocker blocker(size_);
  size_->clear();
  size_->addItems(sizes);
  size_->setEditText(fits ? before : sizes.front());
}

void PictureDialog::choose(const PictureWish& wish) {
  choose_data(*view_, wish.view);
  list_sizes();
  choose_data(*format_, wish.format);
  if (wish.size != PictureWish().size) {
    size_->setEditText(wish.size);
  }
  dpi_->setValue(wish.dpi);
  scale_->setValue(wish.scale);
  choose_data(*theme_, wish.theme);
  language_->choose(wish.language);
  transparent_->setChecked(wish.transparent);
  follow_view();
}

void PictureDialog::follow_view() {
  transparent_->setEnabled(view_->currentData().toString() != QStringLiteral("window"));
  dpi_->setEnabled(wish().has_dpi());
}

PictureWish PictureDialog::wish() const {
  PictureWish wish;
  wish.view = view_->currentData().toString();
  wish.format = format_->currentData().toString();
  wish.size = size_->currentText().trimmed();
  wish.dpi = dpi_->value();
  wish.scale = scale_->value();
  wish.theme = theme_->currentData().toString();
  wish.transparent = transparent_->isChecked() && transparent_->isEnabled();
  wish.language = language_->language();
  return wish;
}

void PictureDialog::make_preview() {
  changed_.stop();
  const QDir folder(folder_.path());
  QFile::remove(folder.filePath(preview_name));
  state_->say(tr("Drawing the preview …"));
  previewing_.start(picture_arguments(for_preview(wish(), picture_preview_dpi), picture_session) +
                        QStringList{QStringLiteral("--out=%1").arg(preview_name)},
                    folder.path());
}

void PictureDialog::show_preview() {
  const QImage image(QDir(folder_.path()).filePath(preview_name));
  preview_->set_pages({image});
  const PictureWish asked = wish();
  state_->say(asked.on_paper() ? tr("Preview of %1").arg(asked.size)
                               : tr("Preview of %1 × %2 pixels").arg(image.width()).arg(image.height()));
}

QString PictureDialog::state() const {
  return state_->text();
}

QString PictureDialog::proposed_file() const {
  const PictureWish asked = wish();
  return ui::proposed_file(subject_.session.program, asked.view, asked.format);
}

void PictureDialog::ask_and_save() {
  const QString format = wish().format;
  QString file = QFileDialog::getSaveFileName(this, tr("Save picture"), proposed_file(),
                                              QStringLiteral("%1 (*.%2)").arg(format.toUpper(), format));
  if (file.isEmpty()) {
    return;
  }
  if (QFileInfo(file).suffix().isEmpty()) {
    file += '.' + format;
  }
  save(file);
}

void PictureDialog::save(const QString& file) {
  remember();
  previewing_.cancel();
  save_->setEnabled(false);
  saving_.start(picture_arguments(wish(), QDir(folder_.path()).filePath(picture_session)),
                QStringLiteral("--out"), file);
}

void PictureDialog::remember() const {
  QSettings settings;
  const PictureWish asked = wish();
  settings.setValue("picture/view", asked.view);
  settings.setValue("picture/format", asked.format);
  settings.setValue("picture/size",
                    size_->currentIndex() == 0 && size_->findText(asked.size) == 0 ? QString() : asked.size);
  settings.setValue("picture/dpi", asked.dpi);
  settings.setValue("picture/scale", asked.scale);
  settings.setValue("picture/theme", asked.theme);
  settings.setValue("picture/transparent", asked.transparent);
}

}  // namespace feedscope::ui
