#include "ui/annotations/annotations_view.h"

#include <QAction>
#include <QColorDialog>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/annotations/annotation_overlay.h"
#include "ui/annotations/annotation_text.h"
#include "ui/fields/focus_outline.h"
#include "ui/fields/whole_number_box.h"
#include "ui/shared/row_copy.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

constexpr int row_height = 22;
constexpr int text_lines = 4;
constexpr int min_size = 6;        // [points]
constexpr int largest_size = 72;   // [points]
constexpr int swatch_pixels = 14;  // of the colour's button

QString list_of_fields() {
  QStringList rows;
  for (const AnnotationField& field : annotation_fields()) {
    rows.append(QStringLiteral("<tr><td><code>{%1}</code>&nbsp;</td><td>%2</td></tr>")
                    .arg(field.name, field.explanation));
  }
  return QStringLiteral("<table>%1</table>").arg(rows.join(QString()));
}

}  // namespace

AnnotationsView::AnnotationsView(AnnotationList& annotations, Cursor& cursor, QWidget* parent)
    : Panel({QStringLiteral("annotations"), tr("Annotations"), Qt::RightDockWidgetArea, false}, parent),
      annotations_(annotations),
      cursor_(cursor),
      model_(new AnnotationTable(annotations, this)),
      table_(new QTableView(this)),
      text_(new QPlainTextEdit(this)),
      colour_(new QToolButton(this)),
      size_(new WholeNumberBox(this)),
      hint_(new QLabel(this)) {
  table_->setModel(model_);
  table_->setAccessibleName(tr("Annotations"));
  table_->setTabKeyNavigation(false);
  new FocusOutline(*table_);
  install_row_copy(*table_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(row_height);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  text_->setAccessibleName(tr("Text of the annotation"));
  text_->setToolTip(tr("Names in braces are replaced by the values at the place:") + list_of_fields());
  text_->setMaximumHeight(text_->fontMetrics().lineSpacing() * text_lines + 12);
  text_->installEventFilter(this);
  table_->installEventFilter(this);
  colour_->setToolTip(tr("Colour of the annotation"));
  colour_->setIconSize({swatch_pixels, swatch_pixels});
  size_->setRange(min_size, largest_size);
  size_->setSuffix(tr(" pt"));
  size_->setToolTip(tr("Text size [points]"));
  hint_->setWordWrap(true);
  make_actions();
  make_layout();

  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    change(tr("text of annotation"), [this](Annotation& item) { item.text = text_->toPlainText(); });
    show_hint();
  });
  connect(size_, &WholeNumberBox::valueChanged, this, [this](int points) {
    change(tr("size of annotation"), [points](Annotation& item) { item.size = points; });
  });
  connect(colour_, &QToolButton::clicked, this, &AnnotationsView::choose_colour);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            if (index.isValid()) {
              annotations_.select(annotations_.items()[static_cast<std::size_t>(index.row())].id);
            }
          });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    const Annotation& item = annotations_.items()[static_cast<std::size_t>(index.row())];
    if (cursor_.valid()) {
      emit time_chosen(time_of(*cursor_.trajectory(), item.place));
    }
  });
  connect(&annotations_, &AnnotationList::changed, this, &AnnotationsView::show_selected);
  connect(&annotations_, &AnnotationList::selection_changed, this, &AnnotationsView::show_selected);
  connect(&cursor_, &Cursor::changed, this, &AnnotationsView::show_hint);
  show_selected();
}

void AnnotationsView::make_actions() {
  const auto put = [this](AnnotationKind kind, const QString& text, const QString& tip, const QString& key) {
    QAction* action = add_action(text, tip, QKeySequence(key));
    action->setIconText(annotation_title(kind));
    connect(action, &QAction::triggered, this, [this, kind] { add(kind); });
  };
  put(AnnotationKind::text, tr("Add &text"), tr("Place text beside the path at the cursor"), {});
  put(AnnotationKind::arrow, tr("Add &arrow"), tr("Point an arrow at the cursor"), {});
  put(AnnotationKind::callout, tr("Add &callout"),
      tr("Place a label with feed, contour error and limiting cause at the cursor"), tr("Ctrl+Shift+C"));
  put(AnnotationKind::dimension, tr("Add &dimension"),
      tr("Show the distance between cursors A and B of the charts, or between the ends of the visible range, "
         "or of the block at the cursor while the whole run is visible"),
      {});
  put(AnnotationKind::region, tr("Add &region"),
      tr("Mark the path between cursors A and B of the charts, or over the visible range, or the block at "
         "the cursor while the whole run is visible"),
      {});
  QAction* remove = add_action(tr("&Remove annotation"), tr("Delete the selected annotation"), {});
  remove->setIconText(tr("Remove"));
  connect(remove, &QAction::triggered, this, [this] { annotations_.remove(annotations_.selected()); });
}

QAction* AnnotationsView::add_action(const QString& text, const QString& tip, const QKeySequence& key) {
  auto* action = new QAction(text, this);
  action->setToolTip(key.isEmpty() ? tip : tr("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  action->setShortcut(key);
  actions_.append(action);
  return action;
}

void AnnotationsView::make_layout() {
  auto* bar = new QToolBar(this);  // shrinks in a narrow panel
  bar->addActions(actions_);
  auto* style = new QHBoxLayout;
  style->addWidget(colour_);
  style->addWidget(size_);
  style->addWidget(hint_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(bar);
  layout->addWidget(table_, 1);
  layout->addWidget(text_);
  layout->addLayout(style);
}

void AnnotationsView::set_toolpath(std::shared_ptr<const Toolpath> toolpath) {
  model_->set_toolpath(std::move(toolpath));
}

void AnnotationsView::set_picture(const AnnotationOverlay& picture) {
  model_->set_teller([&picture](const Annotation& annotation) { return picture.text_of(annotation); });
  connect(&picture, &AnnotationOverlay::run_changed, model_, &AnnotationTable::refresh_texts);
}

void AnnotationsView::edit(int id) {
  annotations_.select(id);
  emit attention_wanted();
  text_->setFocus();
  text_->selectAll();
}

void AnnotationsView::add(AnnotationKind kind) {
  if (!cursor_.valid()) {
    hint_->setText(tr("Open a program first: an annotation belongs to a place on its path."));
    return;
  }
  const Trajectory& trajectory = *cursor_.trajectory();
  Annotation annotation;
  annotation.kind = kind;
  annotation.text = first_text(kind);
  annotation.place = annotation.until = programmed_place(trajectory, cursor_.state().time);
  if (has_two_places(kind)) {
    if (const Stretch stretch = stretch_ ? stretch_() : std::nullopt) {
      annotation.place = programmed_place(trajectory, stretch->front());
      annotation.until = programmed_place(trajectory, stretch->back());
    } else {
      annotation.place.share = 0;
      annotation.until.share = 1;
    }
  }
  annotations_.add(annotation);
  emit attention_wanted();
  text_->setFocus();  // letters typed now go into the text, not to the keys of the view
  text_->selectAll();
}

void AnnotationsView::show_selected() {
  const Annotation* selected = annotations_.find(annotations_.selected());
  for (QWidget* editor :
       {static_cast<QWidget*>(text_), static_cast<QWidget*>(colour_), static_cast<QWidget*>(size_)}) {
    editor->setEnabled(selected != nullptr);
  }
  actions_.back()->setEnabled(selected != nullptr);
  const QSignalBlocker quiet_text(text_);
  const QSignalBlocker quiet_size(size_);
  const QString words = selected == nullptr ? QString() : selected->text;
  if (text_->toPlainText() != words) {
    text_->setPlainText(words);
  }
  size_->setValue(selected == nullptr ? static_cast<int>(Annotation().size)
                                      : static_cast<int>(selected->size));
  QPixmap swatch(swatch_pixels, swatch_pixels);
  swatch.fill(selected == nullptr ? QColor(Qt::transparent) : selected->colour);
  colour_->setIcon(swatch);
  const auto row = selected == nullptr ? -1 : static_cast<int>(selected - annotations_.items().data());
  if (table_->currentIndex().row() != row) {
    table_->setCurrentIndex(row < 0 ? QModelIndex() : model_->index(row, 0));
  }
  show_hint();
}

void AnnotationsView::show_hint() {
  const QString wrong = unknown_field(text_->toPlainText());
  if (!wrong.isEmpty()) {
    hint_->setText(tr("%1 is not a value name; the tooltip of the text lists them.").arg(wrong));
  } else if (annotations_.items().empty()) {
    hint_->setText(tr("Click the path, then add an annotation there."));
  } else {
    hint_->setText(tr("Drag labels to move them; drag the dots of the selected one along the path."));
  }
}

void AnnotationsView::choose_colour() {
  if (const Annotation* selected = annotations_.find(annotations_.selected())) {
    const QColor colour = QColorDialog::getColor(selected->colour, this, tr("Colour of the annotation"));
    if (colour.isValid()) {
      change(tr("colour of annotation"), [&](Annotation& item) { item.colour = colour; });
    }
  }
}

void AnnotationsView::change(const QString& name, const std::function<void(Annotation&)>& edit) {
  if (const Annotation* selected = annotations_.find(annotations_.selected())) {
    Annotation changed = *selected;
    edit(changed);
    annotations_.change(changed, name);
  }
}

bool AnnotationsView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == text_ && event->type() == QEvent::FocusOut) {
    annotations_.end_step();
  }
  if (watched == table_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    annotations_.remove(annotations_.selected());
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void AnnotationsView::follow(Workbench& workbench) {
  const auto show_program = [this, &workbench] { set_toolpath(workbench.shown_program().input.toolpath); };
  connect(&workbench, &Workbench::program_changed, this, show_program);
  connect(this, &AnnotationsView::time_chosen, &workbench.cursor(), &Cursor::set_time);
  show_program();
}

}  // namespace feedscope::ui
