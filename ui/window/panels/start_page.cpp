#include "ui/window/panels/start_page.h"

#include <QAbstractButton>
#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <tuple>

#include "core/analysis/run/run.h"
#include "core/base/data_folder.h"
#include "ui/shared/paths.h"
#include "ui/theme/type_size.h"
#include "ui/window/panels/program_sketch.h"
#include "ui/workbench/recent_files.h"

namespace feedscope::ui {

namespace {

constexpr QSize sketch_size(210, 118);
constexpr int tile_width = 226;
constexpr int tile_height = 164;
constexpr int heading_size = 14;
constexpr int left_width = 320;
constexpr int widest = 1280;
constexpr qsizetype most_recent = 8;

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  set_type_pixels(*label, heading_size);
  label->setWordWrap(true);
  label->setContentsMargins(0, 10, 0, 2);
  return label;
}

/// A line in a list that can be pressed. Drawn here, because a style sheet keeps the colours of the theme in
/// which it was set.
class LineButton : public QPushButton {
 public:
  LineButton(const QString& text, const QString& tip, QWidget* parent) : QPushButton(text, parent) {
    setToolTip(tip);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
  }
  QSize sizeHint() const override {
    return {fontMetrics().horizontalAdvance(text()) + 2 * side_space,
            fontMetrics().height() + 2 * line_space};
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    if (underMouse() || isDown()) {
      painter.fillRect(rect(), palette().color(isDown() ? QPalette::Mid : QPalette::Midlight));
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect inside = rect().adjusted(side_space, 0, -side_space, 0);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, inside.width()));
    if (hasFocus()) {
      painter.setPen(palette().color(QPalette::Highlight));
      painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
  }

 private:
  static constexpr int side_space = 6;
  static constexpr int line_space = 4;
};

/// The area for dropping files: a dashed frame.
class DropFrame : public QWidget {
 public:
  using QWidget::QWidget;

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    constexpr double line = 2;
    constexpr double corner = 6;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Mid), line, Qt::DashLine));
    painter.drawRoundedRect(QRectF(rect()).adjusted(line / 2, line / 2, -line / 2, -line / 2), corner,
                            corner);
  }
};

void empty(QLayout& layout) {
  while (QLayoutItem* item = layout.takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

}  // namespace

std::vector<SampleProgram> start_samples() {
  const std::filesystem::path folder = data_folder() / "resources" / "programs";
  return {
      {folder / "trochoidal_slot.nc", StartPage::tr("Trochoidal slot"),
       StartPage::tr("ISO: short blocks against arcs")},
      {folder / "msaddek_pocket.nc", StartPage::tr("Pocket"),
       StartPage::tr("ISO: sharp and rounded corners")},
      {folder / "freeform_finish.nc", StartPage::tr("Free-form surface"),
       StartPage::tr("ISO: 50 000 short blocks")},
      {folder / "heidenhain_plate.h", StartPage::tr("Plate"), StartPage::tr("Heidenhain: contour and holes")},
      {folder / "sinumerik_plate.mpf", StartPage::tr("Plate with pockets"),
       StartPage::tr("Sinumerik: frames and cycles")},
      {folder / "fanuc_flange.nc", StartPage::tr("Flange"), StartPage::tr("Fanuc: slots and drilling")},
  };
}

StartPage::StartPage(const Workbench& workbench, LessonDesk& desk, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      desk_(desk),
      samples_(start_samples()),
      scroll_(new QScrollArea(this)) {
  setAutoFillBackground(true);
  setAccessibleName(tr("Start page"));
  auto* content = new QWidget(scroll_);
  content->setMaximumWidth(widest);
  auto* columns = new QHBoxLayout(content);
  columns->setContentsMargins(16, 8, 16, 12);
  columns->setSpacing(28);
  columns->addWidget(make_first_steps(), 0, Qt::AlignTop);
  columns->addWidget(make_offers(), 1, Qt::AlignTop);
  scroll_->setWidget(content);
  scroll_->setWidgetResizable(true);
  scroll_->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll_);
  connect(&workbench_, &Workbench::program_changed, this, &StartPage::follow);
  connect(&workbench_, &Workbench::busy_changed, this, &StartPage::follow);
  connect(&desk_, &LessonDesk::listed, this, &StartPage::list_lessons);
  setVisible(workbench_.program() == nullptr && !workbench_.busy());
}

QWidget* StartPage::make_first_steps() {
  auto* part = new QWidget(this);
  part->setFixedWidth(left_width);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("What does the control do with your program?"), part));
  auto* drop = new DropFrame(part);
  auto* inside = new QVBoxLayout(drop);
  inside->setContentsMargins(14, 14, 14, 14);
  auto* open = new QPushButton(tr("Open an NC program or session …"), drop);
  open->setMinimumHeight(36);
  connect(open, &QPushButton::clicked, this, &StartPage::program_wanted);
  inside->addWidget(open);
  auto* or_drop = new QLabel(tr("or drop a program, a session or a machine file here"), drop);
  or_drop->setWordWrap(true);
  or_drop->setAlignment(Qt::AlignCenter);
  inside->addWidget(or_drop);
  layout->addWidget(drop);
  layout->addWidget(heading(tr("What to do first"), part));
  auto* steps = new QLabel(
      tr("<ol style=\"margin-left: -24px\"><li>Open a program. Its language chooses a machine; your own: "
         "<i>File › Machine › Open machine file</i>.</li>"
         "<li><i>Decide</i> says how much time is lost, to what, and which changes would help.</li>"
         "<li><i>Compare tolerances …</i> says which one to set and what it gains.</li>"
         "<li>On paper: <i>File › Report</i>.</li></ol>"),
      part);
  steps->setWordWrap(true);
  layout->addWidget(steps);
  auto* handbook = new LineButton(tr("First steps in the handbook"), {}, part);
  connect(handbook, &QPushButton::clicked, this, &StartPage::handbook_wanted);
  layout->addWidget(handbook);
  layout->addWidget(heading(tr("Opened recently"), part));
  recent_ = new QVBoxLayout;
  recent_->setSpacing(0);
  layout->addLayout(recent_);
  auto* close = new LineButton(tr("Continue without a program (Esc)"), {}, part);
  connect(close, &QPushButton::clicked, this, &QWidget::hide);
  layout->addSpacing(8);
  layout->addWidget(close);
  return part;
}

QWidget* StartPage::make_offers() {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Sample programs"), part));
  sample_grid_ = new QGridLayout;
  sample_grid_->setSpacing(8);
  for (const SampleProgram& sample : samples_) {
    auto* tile = new QToolButton(part);
    tile->setText(QStringLiteral("%1\n%2").arg(sample.title, sample.shows));
    tile->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    tile->setAutoRaise(true);
    tile->setIconSize(sketch_size);
    tile->setFixedSize(tile_width, tile_height);
    tile->setToolTip(to_qstring(sample.file.filename()));
    tile->setFocusPolicy(Qt::StrongFocus);
    connect(tile, &QToolButton::clicked, this, [this, file = sample.file] { emit file_wanted(file); });
    tiles_.push_back(tile);
  }
  layout->addLayout(sample_grid_);
  layout->addWidget(heading(tr("Lessons"), part));
  lesson_grid_ = new QGridLayout;
  lesson_grid_->setHorizontalSpacing(16);
  lesson_grid_->setVerticalSpacing(0);
  layout->addLayout(lesson_grid_);
  return part;
}

void StartPage::cover(const QRect& place) {
  setGeometry(place);
  raise();
}

void StartPage::open() {
  show();
  raise();
}

void StartPage::follow() {
  if (workbench_.program() != nullptr || workbench_.busy()) {
    hide();
  }
}

void StartPage::list_recent() {
  empty(*recent_);
  const QStringList files = RecentFiles::list();
  for (const QString& file : files.mid(0, most_recent)) {
    auto* button = new LineButton(QFileInfo(file).fileName(), file, this);
    connect(button, &QPushButton::clicked, this, [this, file] { emit file_wanted(to_path(file)); });
    recent_->addWidget(button);
  }
  if (files.isEmpty()) {
    recent_->addWidget(new QLabel(tr("No program has been opened yet"), this));
  }
}

void StartPage::list_lessons() {
  empty(*lesson_grid_);
  const std::vector<LessonEntry>& entries = desk_.entries();
  const int rows = static_cast<int>(entries.size() + 1) / 2;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LessonEntry& lesson = entries[i];
    auto* button = new LineButton(tr("%1. %2").arg(i + 1).arg(lesson.title),
                                  tr("%1 (%2 min)").arg(lesson.learn).arg(lesson.minutes), this);
    connect(button, &QPushButton::clicked, this, [this, file = lesson.file] { emit lesson_wanted(file); });
    const int place = static_cast<int>(i);
    lesson_grid_->addWidget(button, place % rows, place / rows);
  }
}

/// Reads the samples on another thread, once.
void StartPage::sketch() {
  if (!paths_.empty() || sketching_.busy()) {
    show_sketches();
    return;
  }
  sketching_.start(
      [samples = samples_](JobControl& control) {
        Paths paths;
        for (const SampleProgram& sample : samples) {
          constexpr std::size_t enough_points = 20'000;
          const LoadedProgram program = load_program(sample.file);
          paths.push_back(
              std::make_shared<const SampledPath>(sample_programmed(*program.toolpath, enough_points)));
          control.progress.report(static_cast<double>(paths.size()) / static_cast<double>(samples.size()));
        }
        return paths;
      },
      [this](const JobOutcome<Paths>& outcome) {
        if (outcome.result) {
          paths_ = *outcome.result;
          show_sketches();
        }
      });
}

void StartPage::show_sketches() {
  for (std::size_t i = 0; i < std::min(paths_.size(), tiles_.size()); ++i) {
    tiles_[i]->setIcon(
        QIcon(QPixmap::fromImage(program_sketch(*paths_[i], sketch_size, devicePixelRatioF(), palette()))));
  }
}

void StartPage::place_samples() {
  const int room = std::min(width(), widest) - left_width - 80;
  const int columns = std::clamp(room / (tile_width + 8), 1, 3);
  for (QToolButton* tile : tiles_) {
    sample_grid_->removeWidget(tile);
  }
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const int place = static_cast<int>(i);
    sample_grid_->addWidget(tiles_[i], place / columns, place % columns, Qt::AlignLeft);
  }
  sample_grid_->setColumnStretch(columns, 1);
}

std::vector<QAbstractButton*> StartPage::buttons() const {
  std::vector<QAbstractButton*> buttons;
  for (QAbstractButton* button : findChildren<QAbstractButton*>()) {
    if (button->isVisible() && button->isEnabled() && (button->focusPolicy() & Qt::TabFocus) != 0) {
      buttons.push_back(button);
    }
  }
  const auto place = [this](const QAbstractButton* button) {
    const QPoint at = button->mapTo(this, QPoint());
    return std::tuple(at.x() >= left_width + scroll_->widget()->x(), at.y(), at.x());
  };
  std::ranges::stable_sort(buttons, {}, place);
  return buttons;
}

bool StartPage::focusNextPrevChild(bool next) {
  const std::vector<QAbstractButton*> all = buttons();
  if (all.empty()) {
    return false;
  }
  const auto at = std::ranges::find(all, focusWidget());
  const auto count = static_cast<std::ptrdiff_t>(all.size());
  const auto now = at == all.end() ? (next ? -1 : count) : at - all.begin();
  QAbstractButton* wanted = all[static_cast<std::size_t>((now + (next ? 1 : -1) + count) % count)];
  wanted->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  scroll_->ensureWidgetVisible(wanted);
  return true;
}

void StartPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    show_sketches();
  }
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_samples();
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  list_recent();
  desk_.list();
  list_lessons();
  sketch();
  if (const auto all = buttons(); !all.empty()) {
    all.front()->setFocus(Qt::OtherFocusReason);
  }
  emit shown(true);
}

void StartPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit shown(false);
}

}  // namespace feedscope::ui
