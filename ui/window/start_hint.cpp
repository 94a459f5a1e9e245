#include "ui/window/start_hint.h"

#include <QHBoxLayout>
#include <QLabel>

namespace feedscope::ui {

StartHint::StartHint(const Workbench& workbench, QWidget* parent)
    : QFrame(parent), workbench_(workbench), text_(new QLabel(this)) {
  setFrameShape(QFrame::StyledPanel);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  text_->setTextFormat(Qt::RichText);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  text_->setText(
      tr("<a href=\"program\">Open an NC program</a> or drop one here, or begin with a "
         "<a href=\"sample\">sample program</a> or a <a href=\"lesson\">lesson</a>."));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 3, 8, 3);
  layout->addWidget(text_);
  connect(text_, &QLabel::linkActivated, this, &StartHint::choose);
  connect(&workbench_, &Workbench::program_changed, this, &StartHint::follow);
  connect(&workbench_, &Workbench::busy_changed, this, &StartHint::follow);
  follow();
}

void StartHint::follow() {
  const bool wanted = workbench_.program() == nullptr && !workbench_.busy();
  setVisible(wanted);
  emit shown(wanted);
}

void StartHint::choose(const QString& link) {
  if (link == QStringLiteral("program")) {
    emit program_wanted();
  } else if (link == QStringLiteral("sample")) {
    emit sample_wanted();
  } else {
    emit lesson_wanted();
  }
}

}  // namespace feedscope::ui
