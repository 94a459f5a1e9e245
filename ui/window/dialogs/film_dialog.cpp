#include "ui/window/dialogs/film_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "ui/fields/number_box.h"
#include "ui/fields/whole_number_box.h"
#include "ui/film/ogg_film.h"
#include "ui/language/in_language.h"
#include "ui/language/texts.h"
#include "ui/session/session_file.h"
#include "ui/shared/paths.h"
#include "ui/window/dialogs/language_box.h"
#include "ui/window/dialogs/proposed_file.h"

namespace feedscope::ui {

namespace {

constexpr int least_width = 460;
constexpr int time_decimals = 3;
constexpr double usual_film_trail = 2;  // [s] of the film
const QStringList film_command{QStringLiteral("render"), QStringLiteral("--progress")};
const QString film_session = QStringLiteral("film.feedscope");
const QString video = QStringLiteral("ogv");
const QString series = QStringLiteral("png");

/// The size rounded down to even width and height.
QString even_size_text(const QSize& size) {
  return QStringLiteral("%1x%2").arg(size.width() / 2 * 2).arg(size.height() / 2 * 2);
}

/// Rounds down to the digits of the field.
double shown_down(double value, int decimals) {
  const double unit = std::pow(10, decimals);
  return std::floor(value * unit + 1e-6) / unit;
}

}  // namespace

FilmDialog::FilmDialog(Subject subject, const QString& executable, QWidget* parent)
    : QDialog(parent),
      subject_(std::move(subject)),
      from_(new NumberBox(this)),
      to_(new NumberBox(this)),
      speed_(new NumberBox(this)),
      fps_(new WholeNumberBox(this)),
      trail_(new NumberBox(this)),
      charts_(new QCheckBox(tr("C&harts below, with a moving cursor"), this)),
      size_(new QComboBox(this)),
      theme_(new QComboBox(this)),
      language_(new LanguageBox(this)),
      format_(new QComboBox(this)),
      length_(new QLabel(this)),
      state_(new StateLine(this)),
      progress_(new QProgressBar(this)),
      save_(new QPushButton(tr("&Save film …"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      making_(executable, film_command, *state_) {
  setWindowTitle(tr("Film"));
  setMinimumWidth(least_width);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  length_->setWordWrap(true);
  length_->setTextFormat(Qt::PlainText);
  constexpr int rows_of_problem = 2;
  length_->setMinimumHeight(rows_of_problem * length_->fontMetrics().lineSpacing());
  length_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* close = new QPushButton(tr("Close"), this);
  for (QPushButton* button : {close, cancel_}) {
    button->setAutoDefault(false);
  }
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(save_);
  buttons->addWidget(cancel_);
  buttons->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(make_form());
  layout->addWidget(state_);
  layout->addStretch(1);
  layout->addWidget(progress_);
  layout->addLayout(buttons);

  for (NumberBox* box : {from_, to_}) {
    connect(box, &NumberBox::valueChanged, this, &FilmDialog::follow_stretch);
  }
  connect(speed_, &NumberBox::valueChanged, this, [this] {
    own_speed_ = true;
    follow_stretch();
  });
  connect(trail_, &NumberBox::valueChanged, this, [this] { own_trail_ = true; });
  connect(fps_, &WholeNumberBox::valueChanged, this, &FilmDialog::follow);
  for (QComboBox* box : {size_, format_}) {
    connect(box, &QComboBox::currentTextChanged, this, &FilmDialog::follow);
  }
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, &FilmDialog::ask_and_save);
  connect(cancel_, &QPushButton::clicked, this, &FilmDialog::cancel);
  connect(&making_, &FileWriting::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(1000 * fraction)); });
  connect(&making_, &FileWriting::ended, this, [this] { show_busy(false); });
  connect(&making_, &FileWriting::saved, this, &FilmDialog::saved);
  show_busy(false);
  show_stretch(subject_.shown);
}

FilmDialog::~FilmDialog() {
  remember();
}

QWidget* FilmDialog::make_form() {
  const double end = shown_down(subject_.duration, time_decimals);
  for (NumberBox* box : {from_, to_, trail_}) {
    box->setDecimals(time_decimals);
    box->setRange(0, end);
    box->setSuffix(QStringLiteral(" s"));
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  constexpr double slowest = 0.0001;
  constexpr double fastest = 10'000;
  constexpr double longest_trail = 1e6;  // [s]
  trail_->setRange(0, longest_trail);
  trail_->setSpecialValueText(tr("none"));
  trail_->setToolTip(tr("How far back the line behind the tool reaches, in seconds of the run"));
  speed_->setDecimals(4);
  speed_->setRange(slowest, fastest);
  speed_->setPrefix(QStringLiteral("× "));
  speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  speed_->setToolTip(tr("Seconds of the run in a second of the film; 1 is real time"));
  fps_->setRange(1, most_frames_a_second);
  for (QAbstractSpinBox* box : std::initializer_list<QAbstractSpinBox*>{from_, to_, speed_, fps_, trail_}) {
    box->setKeyboardTracking(true);  // input shows the length of the film at once
  }
  size_->setEditable(true);
  size_->setInsertPolicy(QComboBox::NoInsert);
  size_->setToolTip(tr("Pixels, such as 1920x1080"));
  size_->addItems({QStringLiteral("1280x720"), QStringLiteral("1920x1080"), QStringLiteral("3840x2160"),
                   even_size_text(subject_.scene)});
  theme_->addItem(tr("as in the window"), QString());
  theme_->addItem(tr("light"), QStringLiteral("light"));
  theme_->addItem(tr("dark"), QStringLiteral("dark"));
  if (OggFilm::is_available()) {
    format_->addItem(tr("Video: one file, .ogv"), video);
  }
  format_->addItem(tr("Series of pictures: PNG files in a folder"), series);

  auto* stretches = new QHBoxLayout;
  const auto add_stretch = [&](const QString& text, const Interval& stretch) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, stretch] { show_stretch(stretch); });
    stretches->addWidget(button);
  };
  add_stretch(tr("As the cha&rts show"), subject_.shown);
  add_stretch(tr("&Whole run"), {0, subject_.duration});
  auto* form = new QWidget(this);
  auto* fields = new QFormLayout(form);
  fields->setContentsMargins(0, 0, 0, 0);
  fields->addRow(tr("&From"), from_);
  fields->addRow(tr("T&o"), to_);
  fields->addRow(QString(), stretches);
  fields->addRow(tr("S&peed"), speed_);
  fields->addRow(tr("Frames a secon&d"), fps_);
  fields->addRow(tr("Length"), length_);
  fields->addRow(tr("&Trail"), trail_);
  fields->addRow(QString(), charts_);
  fields->addRow(tr("Si&ze"), size_);
  fields->addRow(tr("&Colours"), theme_);
  fields->addRow(tr("&Language"), language_);
  fields->addRow(tr("File for&mat"), format_);

  const QSettings settings;
  fps_->setValue(settings.value("film/fps", FilmTimes().fps).toInt());
  charts_->setChecked(settings.value("film/charts").toBool());
  size_->setEditText(settings.value("film/size", FilmWish().size).toString());
  theme_->setCurrentIndex(std::max(0, theme_->findData(settings.value("film/theme").toString())));
  format_->setCurrentIndex(std::max(0, format_->findData(settings.value("film/format").toString())));
  return form;
}

void FilmDialog::remember() const {
  QSettings settings;
  settings.setValue("film/fps", fps_->value());
  settings.setValue("film/charts", charts_->isChecked());
  settings.setValue("film/size", size_->currentText().trimmed());
  settings.setValue("film/theme", theme_->currentData().toString());
  settings.setValue("film/format", format_->currentData().toString());
}

void FilmDialog::show_stretch(const Interval& stretch) {
  const QSignalBlocker blocker(from_);
  from_->setValue(shown_down(stretch.lower, time_decimals));
  const QSignalBlocker other(to_);
  to_->setValue(shown_down(stretch.upper, time_decimals));
  follow_stretch();
}

/// Updates speed and trail until the user chooses them.
void FilmDialog::follow_stretch() {
  if (!own_speed_) {
    const QSignalBlocker blocker(speed_);
    speed_->setValue(usual_film_speed(to_->value() - from_->value()));
  }
  if (!own_trail_) {
    const QSignalBlocker blocker(trail_);
    trail_->setValue(usual_film_trail * speed_->value());
  }
  follow();
}

QString FilmDialog::problem() const {
  const FilmTimes times = wish().times;
  const QLocale locale;
  if (times.from >= times.to) {
    return tr("The film must end after it begins.");
  }
  if (times.frames() > most_film_frames) {
    return tr("%1 frames; at most %2 can be written. The speed must be %3 at least.")
        .arg(locale.toString(static_cast<qulonglong>(times.frames())),
             locale.toString(static_cast<qulonglong>(most_film_frames)),
             locale.toString(times.least_speed(), 'g', 3));
  }
  static const QRegularExpression pixels(QStringLiteral("^(\\d+)[xX](\\d+)$"));
  const QRegularExpressionMatch size = pixels.match(wish().size);
  if (!size.hasMatch()) {
    return tr("The size is a width and a height in pixels, such as 1280x720.");
  }
  const bool even = size.captured(1).toInt() % 2 == 0 && size.captured(2).toInt() % 2 == 0;
  return !even && format_->currentData().toString() == video
             ? tr("A video needs an even width and an even height.")
             : QString();
}

void FilmDialog::follow() {
  const QString wrong = problem();
  const FilmTimes times = wish().times;
  length_->setText(wrong.isEmpty() ? tr("%1 in %2 frames")
                                         .arg(clock_text(times.length()),
                                              QLocale().toString(static_cast<qulonglong>(times.frames())))
                                   : wrong);
  length_->setForegroundRole(wrong.isEmpty() ? QPalette::WindowText : QPalette::BrightText);
  save_->setEnabled(wrong.isEmpty() && !busy());
}

QString FilmDialog::length_text() const {
  return length_->text();
}

QString FilmDialog::state() const {
  return state_->text();
}

FilmWish FilmDialog::wish() const {
  FilmWish wish;
  wish.times = {from_->value(), to_->value(), speed_->value(), fps_->value()};
  wish.trail = trail_->value();
  wish.charts = charts_->isChecked();
  wish.size = size_->currentText().trimmed();
  wish.theme = theme_->currentData().toString();
  wish.language = language_->language();
  return wish;
}

void FilmDialog::choose(const FilmWish& wish) {
  show_stretch({wish.times.from, wish.times.to});
  speed_->setValue(wish.times.speed);
  fps_->setValue(wish.times.fps);
  trail_->setValue(wish.trail);
  own_speed_ = true;
  own_trail_ = true;
  charts_->setChecked(wish.charts);
  size_->setEditText(wish.size);
  theme_->setCurrentIndex(std::max(0, theme_->findData(wish.theme)));
  language_->choose(wish.language);
}

QString FilmDialog::proposed_file() const {
  return ui::proposed_file(subject_.session.program, QStringLiteral("film"), video);
}

void FilmDialog::ask_and_save() {
  const QFileInfo program(to_qstring(subject_.session.program));
  QString file;
  if (format_->currentData().toString() == video) {
    file = QFileDialog::getSaveFileName(this, tr("Save film"), proposed_file(), tr("Video (*.ogv)"));
    if (!file.isEmpty() && QFileInfo(file).suffix().toLower() != video) {
      file += QStringLiteral(".ogv");
    }
  } else {
    file = QFileDialog::getExistingDirectory(this, tr("Folder for the pictures"),
                                             folder_for_files_of(subject_.session.program));
    if (!file.isEmpty()) {
      file += QStringLiteral("/%1-%05d.png").arg(program.completeBaseName().replace('%', '_'));
    }
  }
  if (!file.isEmpty()) {
    save(file);
  }
}

void FilmDialog::save(const QString& file) {
  remember();
  const QString session = QDir(folder_.path()).filePath(film_session);
  try {
    write_session(subject_.session, to_path(session));
  } catch (const InputError& error) {
    state_->say_failure(failure_text(error));
    return;
  }
  making_.start(film_arguments(wish(), session), QStringLiteral("--film"), file);
  show_busy(true);
}

void FilmDialog::cancel() {
  making_.cancel();
  show_busy(false);
  state_->say(tr("Cancelled; nothing has been written."));
}

void FilmDialog::show_busy(bool busy) {
  progress_->setValue(0);
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
  save_->setVisible(!busy);
  follow();
}

}  // namespace feedscope::ui
