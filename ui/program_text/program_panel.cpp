#include "ui/program_text/program_panel.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <utility>

#include "ui/language/shown_numbers.h"
#include "ui/program_text/find_bar.h"
#include "ui/program_text/go_to_bar.h"
#include "ui/shared/panel_action.h"
#include "ui/theme/type_size.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {

namespace {

QString ranges_text(const Bounds& bounds) {
  const QLocale locale;
  const int digits = unit_system() == UnitSystem::metric ? 7 : 5;
  const auto number = [&](double value) {
    return locale.toString(in_shown_unit(value, Dimension::length), 'g', digits).replace('-', QChar(0x2212));
  };
  QStringList ranges;
  for (int axis = 0; axis < 3; ++axis) {
    if (bounds.min[axis] <= bounds.max[axis]) {
      ranges.append(ProgramPanel::tr("%1 %2 to %3")
                        .arg(QChar(coordinate_names[static_cast<std::size_t>(axis)]))
                        .arg(number(bounds.min[axis]), number(bounds.max[axis])));
    }
  }
  return ranges.isEmpty() ? ProgramPanel::tr("none") : ranges.join(QStringLiteral(", "));
}

}  // namespace

ProgramPanel::ProgramPanel(QWidget* parent)
    : Panel({QStringLiteral("program"), tr("Program"), Qt::LeftDockWidgetArea}, parent),
      view_(new ProgramView(this)),
      find_bar_(new FindBar(*view_, this)),
      go_to_bar_(new GoToBar(*view_, this)),
      extents_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(find_bar_);
  layout->addWidget(go_to_bar_);
  layout->addWidget(view_, 1);
  layout->addWidget(extents_);
  extents_->setWordWrap(true);
  extents_->setMargin(4);
  extents_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  extents_->hide();
  find_bar_->hide();
  go_to_bar_->hide();
  setFocusProxy(view_);
  view_->set_search(&find_bar_->search());
  add_actions();
}

template <typename Slot>
QAction* ProgramPanel::add_action(const QString& text, const QString& tip, const QKeySequence& key,
                                  Slot slot) {
  QAction* action = make_action(this, text, tip, key, slot);
  addAction(action);
  actions_.append(action);
  return action;
}

void ProgramPanel::follow(Workbench& workbench) {
  const auto show_program = [this, &workbench] { set_program(workbench.program()); };
  const auto show_run = [this, &workbench] {
    const auto shown = workbench.shown();
    view_->set_times(shown == nullptr ? nullptr : shown->line_times);
  };
  const auto show_cursor = [this, &cursor = workbench.cursor()] {
    view_->show_line(cursor.valid() ? cursor.state().line : 0);
  };
  connect(&workbench, &Workbench::program_changed, this, show_program);
  connect(&workbench, &Workbench::run_changed, this, show_run);
  connect(&workbench.cursor(), &Cursor::changed, this, show_cursor);
  connect(view_, &ProgramView::line_chosen, &workbench.cursor(), &Cursor::set_line);
  connect(&workbench, &Workbench::busy_changed, view_, &ProgramView::set_reading);
  view_->set_reading(workbench.busy());
  show_program();
  show_run();
  show_cursor();
}

void ProgramPanel::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  show_extents();
}

void ProgramPanel::show_extents() {
  constexpr int strip = 150;  // [px]
  extents_->setVisible(has_extents_ && width() >= type_pixels(strip));
}

void ProgramPanel::add_actions() {
  add_action(tr("Find …"), tr("Find in the program"), QKeySequence::Find, [this] {
    go_to_bar_->hide();
    find_bar_->open();
  });
  add_action(tr("Find next"), tr("Go to the next match"), QKeySequence(Qt::Key_F3),
             [this] { find_bar_->step(true); });
  add_action(tr("Find previous"), tr("Go to the previous match"), QKeySequence(Qt::SHIFT | Qt::Key_F3),
             [this] { find_bar_->step(false); });
  add_action(tr("Go to line …"), tr("Go to a line of the program"), QKeySequence(tr("Ctrl+G")), [this] {
    find_bar_->close_bar();
    go_to_bar_->open();
  });
  add_action(tr("Larger text"), tr("Larger program text; Ctrl and the wheel do the same"),
             QKeySequence(tr("Ctrl+Alt++")), [this] { view_->zoom(1); });
  add_action(tr("Smaller text"), tr("Smaller program text; Ctrl and the wheel do the same"),
             QKeySequence(tr("Ctrl+Alt+-")), [this] { view_->zoom(-1); });
  QAction* copy = add_action(tr("Copy program text"), tr("Copy the selected text (Ctrl+C)"), {},
                             [this] { view_->copy(); });
  QAction* all = add_action(tr("Select all program text"), tr("Select the whole program (Ctrl+A)"), {},
                            [this] { view_->select_all(); });
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  view_->addActions({copy, all, actions_[0], actions_[3]});
}

void ProgramPanel::show_extents(const Program* program) {
  has_extents_ = program != nullptr && !program->cutting_bounds.empty();
  show_extents();
  if (program != nullptr) {
    extents_->setText(
        tr("Cutting [%1]: %2").arg(unit_of(Dimension::length), ranges_text(program->cutting_bounds)));
    extents_->setToolTip(tr("Extents [%1], including arcs\nCutting: %2\nRapid: %3\nAll: %4")
                             .arg(unit_of(Dimension::length), ranges_text(program->cutting_bounds),
                                  ranges_text(program->rapid_bounds), ranges_text(program->bounds)));
  }
}

void ProgramPanel::set_program(std::shared_ptr<const Program> program) {
  show_extents(program.get());
  view_->set_program(std::move(program));
  find_bar_->search().set_text(view_->text());
}

void ProgramPanel::go_to(std::uint32_t line, std::uint32_t column) {
  view_->go_to({line, column > 0 ? column - 1 : 0});
  view_->setFocus();
}

}  // namespace feedscope::ui
