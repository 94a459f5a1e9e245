#include "ui/program_text/go_to_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <algorithm>
#include <limits>

#include "ui/fields/whole_number_box.h"
#include "ui/program_text/program_view.h"

namespace feedscope::ui {

GoToBar::GoToBar(ProgramView& view, QWidget* parent)
    : InputBar(view, parent), view_(view), input_(new WholeNumberBox(this)), count_(new QLabel(this)) {
  input_->setAccessibleName(tr("Line to go to"));
  input_->setToolTip(tr("Line to go to (Enter)"));
  take_keys_of(input_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(new QLabel(tr("Line"), this));
  layout->addWidget(input_);
  layout->addWidget(count_, 1);
}

void GoToBar::open() {
  const std::uint32_t lines = std::max(1U, view_.text().line_count());
  input_->setRange(1, static_cast<int>(std::min<std::uint32_t>(lines, std::numeric_limits<int>::max())));
  input_->setValue(static_cast<int>(view_.caret().line));
  count_->setText(tr("of %1").arg(QLocale().toString(lines)));
  show();
  input_->setFocus(Qt::ShortcutFocusReason);
  input_->selectAll();
}

void GoToBar::enter(Qt::KeyboardModifiers) {
  view_.go_to({static_cast<std::uint32_t>(input_->value()), 0});
  close_bar();
}

}  // namespace feedscope::ui
