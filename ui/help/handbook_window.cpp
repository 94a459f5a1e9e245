#include "ui/help/handbook_window.h"

#include <QDesktopServices>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <QSplitter>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "ui/language/in_language.h"
#include "ui/language/language.h"

namespace feedscope::ui {

namespace {

constexpr QSize usual_size{900, 640};
constexpr int list_width = 240;
constexpr int min_search = 2;  // letters; a single one occurs on every page

}  // namespace

HandbookWindow::HandbookWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      text_(new QTextBrowser(this)) {
  setWindowTitle(tr("Feedscope handbook"));
  resize(usual_size);
  search_->setPlaceholderText(tr("Search the handbook"));
  search_->setAccessibleName(tr("Search the handbook"));
  search_->setClearButtonEnabled(true);
  search_->setToolTip(tr("Lists the pages that contain all words; Enter goes to the next match"));
  list_->setAccessibleName(tr("Pages"));
  text_->setAccessibleName(tr("Page"));
  text_->setOpenLinks(false);

  auto* side = new QWidget(this);
  auto* side_layout = new QVBoxLayout(side);
  side_layout->setContentsMargins(0, 0, 0, 0);
  side_layout->addWidget(search_);
  side_layout->addWidget(list_);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(side);
  splitter->addWidget(text_);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({list_width, usual_size.width() - list_width});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(splitter);

  connect(search_, &QLineEdit::textChanged, this, [this] {
    list_pages();
    mark_words();
  });
  connect(search_, &QLineEdit::returnPressed, this, &HandbookWindow::find_next);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) {
      open(item->data(Qt::UserRole).toString(), {});
    }
  });
  connect(text_, &QTextBrowser::anchorClicked, this, &HandbookWindow::follow);
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, this, [this] {
    search_->setFocus();
    search_->selectAll();
  });
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, [this] {
    if (search_->text().isEmpty()) {
      close();
    } else {
      search_->clear();
    }
  });
}

void HandbookWindow::show_page(const QString& name) {
  load();
  search_->clear();
  list_pages();
  open(handbook_ && handbook_->find(name.toStdString()) != nullptr ? name : QStringLiteral("index"), {});
  show();
  raise();
  activateWindow();
  search_->setFocus();
}

void HandbookWindow::load() {
  try {
    handbook_.emplace(chosen_language().toStdString());
  } catch (const InputError& error) {
    handbook_.reset();
    text_->setPlainText(failure_text(error));
  }
}

void HandbookWindow::list_pages() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  if (!handbook_) {
    return;
  }
  const QString words = search_->text().trimmed();
  for (const HandbookPage* page :
       handbook_->search(words.size() >= min_search ? words.toStdString() : std::string())) {
    auto* item = new QListWidgetItem(QString::fromStdString(page->title), list_);
    item->setData(Qt::UserRole, QString::fromStdString(page->name));
    if (item->data(Qt::UserRole) == page_) {
      list_->setCurrentItem(item);
    }
  }
}

void HandbookWindow::open(const QString& name, const QString& anchor) {
  const HandbookPage* page = handbook_ ? handbook_->find(name.toStdString()) : nullptr;
  if (page == nullptr) {
    return;
  }
  if (page_ != name || text_->toPlainText().isEmpty()) {
    page_ = name;
    text_->document()->setDefaultStyleSheet(QStringLiteral(
        "pre, code { font-family: 'DejaVu Sans Mono', monospace; } li { margin-bottom: 3px; }"));
    text_->setHtml(QString::fromStdString(page_html(*page, ".md")));
    mark_words();
  }
  if (anchor.isEmpty()) {
    text_->moveCursor(QTextCursor::Start);
  } else {
    text_->scrollToAnchor(anchor);
  }
  const QSignalBlocker quiet(list_);
  for (int row = 0; row < list_->count(); ++row) {
    if (list_->item(row)->data(Qt::UserRole) == name) {
      list_->setCurrentRow(row);
    }
  }
}

void HandbookWindow::follow(const QUrl& link) {
  if (!link.scheme().isEmpty()) {
    QDesktopServices::openUrl(link);
    return;
  }
  QString name = link.path();
  name.chop(name.endsWith(QLatin1String(".md")) ? 3 : 0);
  open(name.isEmpty() ? page_ : name, link.fragment());
}

void HandbookWindow::find_next() {
  const QString words = search_->text().trimmed();
  const QString first = words.section(QLatin1Char(' '), 0, 0, QString::SectionSkipEmpty);
  if (words.size() < min_search || list_->count() == 0) {
    return;
  }
  const bool whole = text_->document()->toPlainText().contains(words, Qt::CaseInsensitive);
  if (list_->currentItem() != nullptr && text_->find(whole ? words : first)) {
    return;
  }
  list_->setCurrentRow((list_->currentRow() + 1) % list_->count());
  text_->moveCursor(QTextCursor::Start);
  text_->find(text_->document()->toPlainText().contains(words, Qt::CaseInsensitive) ? words : first);
}

void HandbookWindow::mark_words() {
  QList<QTextEdit::ExtraSelection> marks;
  const QStringList words = search_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (const QString& word : words) {
    QTextCursor at(text_->document());
    while (word.size() >= min_search && !(at = text_->document()->find(word, at)).isNull()) {
      QTextEdit::ExtraSelection mark;
      mark.cursor = at;
      mark.format.setBackground(QColor(0xff, 0xe0, 0x66));
      mark.format.setForeground(Qt::black);
      marks.append(mark);
    }
  }
  text_->setExtraSelections(marks);
}

}  // namespace feedscope::ui
