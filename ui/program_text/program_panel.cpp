#include "ui/views/program/program_panel.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <utility>

#include "ui/models/panel_action.h"
#include "ui/views/program/find_bar.h"
#include "ui/views/program/go_to_bar.h"

namespace feedscope::ui {

namespace {

QString ranges_text(const Bounds& bounds) {
  const QLocale locale;
  const auto number = [&](double value) { return locale.toString(value, 'g', 7); };
  QStringList ranges;
  for (int axis = 0; axis < 3; ++axis) {
    if (bounds.min[axis] <= bounds.max[axis]) {
      ranges.append(ProgramPanel::tr("%1 %2 to %3")
                        .arg(QChar(axis_names[static_cast<std::size_t>(axis)]))
                        .arg(number(bounds.min[axis]), number(bounds.max[axis])));
    }
  }
  return ranges.isEmpty() ? ProgramPanel::tr("none") : ranges.join(QStringLiteral(", "));
}

}  // namespace

ProgramPanel::ProgramPanel(QWidget* parent)
    : QWidget(parent),
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

void ProgramPanel::add_actions() {
  add_action(tr("Find …"), tr("Find in the program"), QKeySequence::Find, [this] {
    go_to_bar_->hide();
    find_bar_->open();
  });
  add_action(tr("Find next"), tr("Go to the next hit"), QKeySequence(Qt::Key_F3),
             [this] { find_bar_->step(true); });
  add_action(tr("Find previous"), tr("Go to the hit before"), QKeySequence(Qt::SHIFT | Qt::Key_F3),
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
  extents_->setVisible(program != nullptr && !program->cutting_bounds.empty());
  if (program != nullptr) {
    extents_->setText(tr("Cutting [mm]: %1").arg(ranges_text(program->cutting_bounds)));
    extents_->setToolTip(tr("Extents in mm, arcs in full\nCutting: %1\nRapid: %2\nAll: %3")
                             .arg(ranges_text(program->cutting_bounds), ranges_text(program->rapid_bounds),
                                  ranges_text(program->bounds)));
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
