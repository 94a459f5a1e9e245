#include "ui/window/dialogs/report_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "ui/language/in_language.h"
#include "ui/session/session_file.h"
#include "ui/shared/paths.h"
#include "ui/window/dialogs/language_box.h"
#include "ui/window/dialogs/page_preview.h"
#include "ui/window/dialogs/proposed_file.h"

namespace feedscope::ui {

namespace {

constexpr QSize usual_size(1060, 720);
constexpr int form_width = 390;
constexpr int pause_before_preview = 600;  // [ms] after the last change
constexpr int preview_dpi = 96;
constexpr int list_rows = 3;
const QStringList report_command{QStringLiteral("report"), QStringLiteral("--progress")};
const QString session_name = QStringLiteral("preview.feedscope");

QListWidgetItem* checkable(QListWidget* list, const QString& text, bool on) {
  auto* item = new QListWidgetItem(text, list);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
  item->setToolTip(text);
  return item;
}

/// A field for a file's name with a button that asks for it.
template <typename Ask>
QWidget* file_row(QLineEdit* line, const QString& tip, QWidget* parent, Ask ask) {
  auto* row = new QWidget(parent);
  auto* choose = new QPushButton(QStringLiteral("…"), row);
  choose->setToolTip(tip);
  choose->setAccessibleName(tip);
  choose->setAutoDefault(false);
  choose->setMaximumWidth(choose->sizeHint().height() * 3 / 2);
  line->setToolTip(tip);
  line->setClearButtonEnabled(true);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(line, 1);
  layout->addWidget(choose);
  QObject::connect(choose, &QPushButton::clicked, parent, ask);
  return row;
}

}  // namespace

ReportDialog::ReportDialog(Subject subject, const QString& executable, QWidget* parent)
    : QDialog(parent),
      subject_(std::move(subject)),
      title_(new QLineEdit(this)),
      author_(new QLineEdit(this)),
      dated_(new QCheckBox(tr("With the date of today"), this)),
      logo_(new QLineEdit(this)),
      page_(new QLineEdit(this)),
      language_(new LanguageBox(this)),
      paper_(new QComboBox(this)),
      remarks_(new QPlainTextEdit(this)),
      runs_(new QListWidget(this)),
      parts_(new QListWidget(this)),
      with_session_(new QCheckBox(tr("Save the session beside it, to make it again"), this)),
      preview_(new PagePreview(this)),
      progress_(new QProgressBar(this)),
      state_(new StateLine(this)),
      save_(new QPushButton(tr("&Save report …"), this)),
      previewing_(executable, report_command),
      saving_(executable, report_command, *state_) {
  setWindowTitle(tr("Report"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
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
  layout->addWidget(progress_);
  layout->addLayout(buttons);
  const QSize room = screen()->availableSize() - QSize(40, 60);
  resize(usual_size.boundedTo(room));

  changed_.setSingleShot(true);
  changed_.setInterval(pause_before_preview);
  const auto change = [this] { changed_.start(); };
  for (const QLineEdit* line : {title_, author_, logo_, page_}) {
    connect(line, &QLineEdit::textChanged, this, change);
  }
  connect(remarks_, &QPlainTextEdit::textChanged, this, change);
  connect(dated_, &QCheckBox::toggled, this, change);
  connect(language_, &QComboBox::currentIndexChanged, this, change);
  connect(paper_, &QComboBox::currentIndexChanged, this, change);
  connect(runs_, &QListWidget::itemChanged, this, change);
  connect(parts_, &QListWidget::itemChanged, this, change);
  connect(&changed_, &QTimer::timeout, this, &ReportDialog::make_preview);
  connect(save_, &QPushButton::clicked, this, &ReportDialog::ask_and_save);
  connect(&previewing_, &CommandProcess::done, this, &ReportDialog::show_pages);
  connect(&previewing_, &CommandProcess::failed, this, [this](const QString& message) {
    show_progress(false);
    state_->say_failure(message);
  });
  connect(&saving_, &FileWriting::ended, this, [this] {
    save_->setEnabled(true);
    show_progress(false);
  });
  connect(&saving_, &FileWriting::saved, this, &ReportDialog::saved);
  const auto show_fraction = [this](double fraction) {
    progress_->setValue(static_cast<int>(1000 * fraction));
  };
  connect(&previewing_, &CommandProcess::progressed, this, show_fraction);
  connect(&saving_, &FileWriting::progressed, this, show_fraction);
  make_preview();
}

ReportDialog::~ReportDialog() {
  remember();
}

QWidget* ReportDialog::make_form() {
  const QSettings settings;
  author_->setText(settings.value("report/author").toString());
  logo_->setText(settings.value("report/logo").toString());
  page_->setText(settings.value("report/template").toString());
  paper_->setObjectName(QStringLiteral("paper"));
  paper_->addItem(QStringLiteral("A4"), QString());
  paper_->addItem(QStringLiteral("Letter"), QStringLiteral("Letter"));
  paper_->setCurrentText(settings.value("report/paper").toString());
  title_->setPlaceholderText(to_qstring(subject_.session.program.filename()));
  page_->setPlaceholderText(tr("as supplied"));
  remarks_->setPlaceholderText(tr("What is to be said first, in your words"));
  remarks_->setTabChangesFocus(true);
  remarks_->setAccessibleName(tr("Own words"));
  const int line = remarks_->fontMetrics().lineSpacing();
  remarks_->setMaximumHeight(4 * line);
  make_lists();
  auto* form = new QWidget(this);
  form->setFixedWidth(form_width);
  auto* fields = new QFormLayout;
  fields->setContentsMargins(0, 0, 0, 0);
  fields->addRow(tr("&Title"), title_);
  fields->addRow(tr("&Author"), author_);
  fields->addRow(QString(), dated_);
  fields->addRow(tr("La&nguage"), language_);
  fields->addRow(tr("&Paper"), paper_);
  fields->addRow(tr("&Own words"), remarks_);
  fields->addRow(tr("&Logo"), file_row(logo_, tr("Picture above the title: PNG, JPEG or SVG"), this,
                                       [this] { ask_for_logo(); }));
  fields->addRow(tr("T&emplate"),
                 file_row(page_, tr("HTML template of your own"), this, [this] { ask_for_template(); }));
  auto* layout = new QVBoxLayout(form);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(fields);
  auto* of_runs = new QLabel(tr("&Runs"), form);
  of_runs->setBuddy(runs_);
  auto* of_parts = new QLabel(tr("What &goes in"), form);
  of_parts->setBuddy(parts_);
  layout->addWidget(of_runs);
  layout->addWidget(runs_);
  layout->addWidget(of_parts);
  layout->addWidget(parts_, 1);
  layout->addWidget(with_session_);
  with_session_->setToolTip(
      tr("Writes a session file of the same name, and the command that makes the report of it"));
  return form;
}

void ReportDialog::make_lists() {
  for (const QString& name : subject_.run_names) {
    checkable(runs_, name, true);
  }
  const int row = runs_->fontMetrics().lineSpacing() + 8;
  runs_->setMaximumHeight(std::min(static_cast<int>(subject_.run_names.size()), list_rows) * row + 6);
  const QStringList changed = QSettings().value("report/changed_parts").toStringList();
  for (const ReportPart& part : report_parts()) {
    const bool long_work = subject_.takes_long && part.placeholders.contains(QStringLiteral("time_changes"));
    checkable(parts_, part.title, !long_work && part.usual != changed.contains(part.key()));
  }
}

ReportWish ReportDialog::wish() const {
  ReportWish wish;
  wish.title = title_->text().trimmed();
  wish.author = author_->text().trimmed();
  wish.date = dated_->isChecked() ? QDate::currentDate() : QDate();
  wish.remarks = remarks_->toPlainText().trimmed();
  wish.logo = logo_->text().trimmed();
  wish.page = page_->text().trimmed();
  wish.language = language_->language();
  wish.paper = paper_->currentData().toString();
  const std::vector<ReportPart> parts = report_parts();
  wish.with.clear();
  for (int i = 0; i < parts_->count(); ++i) {
    const ReportPart& part = parts[static_cast<std::size_t>(i)];
    const bool ticked = parts_->item(i)->checkState() == Qt::Checked;
    if (ticked && !part.section.isEmpty()) {
      wish.with.append(part.section);
    } else if (!ticked) {
      wish.without += part.placeholders;
    }
  }
  for (int i = 0; i < runs_->count(); ++i) {
    wish.runs.push_back(runs_->item(i)->checkState() == Qt::Checked);
  }
  return wish;
}

void ReportDialog::keep_session(bool keep) {
  with_session_->setChecked(keep);
}

void ReportDialog::make_preview() {
  changed_.stop();
  ReportWish asked = wish();
  if (std::ranges::find(asked.runs, true) == asked.runs.end()) {
    previewing_.cancel();
    save_->setEnabled(false);
    show_progress(false);
    state_->say_failure(tr("Tick a run at least."));
    return;
  }
  save_->setEnabled(!saving_.busy());
  asked.without.append(QStringLiteral("commands"));  // they would be those of the preview's session
  const QDir folder(folder_.path());
  for (const QString& page : folder.entryList({QStringLiteral("page-*.png")})) {
    QFile::remove(folder.filePath(page));
  }
  try {
    write_session(with_runs(subject_.session, asked.runs), to_path(folder.filePath(session_name)));
  } catch (const InputError& error) {
    state_->say_failure(failure_text(error));
    return;
  }
  state_->say(tr("Making the preview …"));
  show_progress(true);
  const int dpi = static_cast<int>(preview_dpi * devicePixelRatioF());
  previewing_.start(report_arguments(asked, session_name) +
                        QStringList{QStringLiteral("--dpi=%1").arg(dpi), QStringLiteral("--out=page.png")},
                    folder.path());
}

void ReportDialog::show_pages() {
  QList<QImage> pages;
  const QDir folder(folder_.path());
  for (int page = 1;; ++page) {
    QImage image(folder.filePath(QStringLiteral("page-%1.png").arg(page)));
    if (image.isNull()) {
      break;
    }
    pages.append(image);
  }
  preview_->set_pages(pages);
  show_progress(false);
  state_->say(pages.size() == 1 ? tr("1 page") : tr("%1 pages").arg(pages.size()));
}

void ReportDialog::show_progress(bool on) {
  progress_->setValue(0);
  progress_->setVisible(on || saving_.busy());
}

void ReportDialog::ask_for_logo() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Logo"), logo_->text(),
                                                    tr("Pictures (*.png *.jpg *.jpeg *.svg);;All files (*)"));
  if (!file.isEmpty()) {
    logo_->setText(file);
  }
}

void ReportDialog::ask_for_template() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Template"), page_->text(),
                                                    tr("HTML (*.html *.htm);;All files (*)"));
  if (!file.isEmpty()) {
    page_->setText(file);
  }
}

void ReportDialog::ask_and_save() {
  QString file = QFileDialog::getSaveFileName(
      this, tr("Save report"),
      proposed_file(subject_.session.program, QStringLiteral("report"), QStringLiteral("pdf")),
      tr("Document (*.pdf);;Web page (*.html)"));
  if (file.isEmpty()) {
    return;
  }
  if (QFileInfo(file).suffix().isEmpty()) {
    file += QStringLiteral(".pdf");
  }
  save(file);
}

void ReportDialog::save(const QString& file) {
  remember();
  ReportWish asked = wish();
  const QFileInfo target(file);
  const bool keeps_session = with_session_->isChecked();
  QString session = QDir(folder_.path()).filePath(QStringLiteral("saved.feedscope"));
  if (keeps_session) {
    session = target.absoluteDir().filePath(target.completeBaseName() + session_suffix);
  } else {
    asked.without.append(QStringLiteral("commands"));
  }
  try {
    write_session(with_runs(subject_.session, asked.runs), to_path(session));
  } catch (const InputError& error) {
    state_->say_failure(failure_text(error));
    return;
  }
  previewing_.cancel();
  save_->setEnabled(false);
  saving_.start(report_arguments(asked, keeps_session ? QFileInfo(session).fileName() : session),
                QStringLiteral("--out"), file);
  show_progress(true);
}

void ReportDialog::remember() const {
  QSettings settings;
  settings.setValue("report/author", author_->text().trimmed());
  settings.setValue("report/paper", paper_->currentText());
  settings.setValue("report/logo", logo_->text().trimmed());
  settings.setValue("report/template", page_->text().trimmed());
  QStringList changed;
  const std::vector<ReportPart> parts = report_parts();
  for (int i = 0; i < parts_->count(); ++i) {
    const ReportPart& part = parts[static_cast<std::size_t>(i)];
    if ((parts_->item(i)->checkState() == Qt::Checked) != part.usual) {
      changed.append(part.key());
    }
  }
  settings.setValue("report/changed_parts", changed);
}

}  // namespace feedscope::ui
