#include "ui/scene_view/split_overlay.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

constexpr int handle_width = 24;
constexpr double line_width = 2;
constexpr double grip_radius = 11;
constexpr int beside_line = 8;
constexpr int below_legend = 30;
constexpr double share_a_step = 0.02;
constexpr int to_the_end = 1000;  // steps

QLabel* make_label(QWidget& parent) {
  auto* label = new QLabel(&parent);
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  label->setAutoFillBackground(true);
  label->setMargin(3);
  return label;
}

}  // namespace

QString run_mark(const QString& name, const QColor& colour) {
  return QStringLiteral("<span style='color:%1'>&#9632;</span> %2").arg(colour.name(), name.toHtmlEscaped());
}

SplitHandle::SplitHandle(QWidget* parent) : QWidget(parent) {
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(tr("Drag to show more of one run or the other"));
  setAccessibleName(tr("Dividing line between the two runs"));
}

void SplitHandle::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = hasFocus() ? palette().color(QPalette::Highlight) : theme_colours(palette()).text;
  const QPointF middle(width() / 2.0, height() / 2.0);
  painter.setPen(QPen(line, line_width));
  painter.drawLine(QPointF(middle.x(), 0), QPointF(middle.x(), height()));
  painter.setBrush(palette().color(QPalette::Window));
  painter.drawEllipse(middle, grip_radius, grip_radius);
  painter.setBrush(line);
  painter.setPen(Qt::NoPen);
  for (const double side : {-1.0, 1.0}) {
    const QPointF tip = middle + QPointF(side * 7, 0);
    painter.drawPolygon(QPolygonF{tip, tip - QPointF(side * 4, 3.5), tip - QPointF(side * 4, -3.5)});
  }
}

void SplitHandle::mousePressEvent(QMouseEvent* event) {
  grabbed_at_ = static_cast<int>(event->position().x()) - width() / 2;
}

void SplitHandle::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) {
    emit dragged(mapToParent(event->position().toPoint()).x() - grabbed_at_);
  }
}

void SplitHandle::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      emit stepped(-1);
      break;
    case Qt::Key_Right:
      emit stepped(1);
      break;
    case Qt::Key_Home:
      emit stepped(-to_the_end);
      break;
    case Qt::Key_End:
      emit stepped(to_the_end);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

SplitOverlay::SplitOverlay(SceneView& left, SceneView* right, QWidget* right_name, double share)
    : left_(left),
      right_(right),
      pane_(new QWidget(&left)),
      handle_(new SplitHandle(&left)),
      left_name_(make_label(left)),
      right_name_(right_name),
      left_note_(make_label(left)),
      right_note_(make_label(left)),
      share_(std::clamp(share, 0.0, 1.0)) {
  right_->setParent(pane_);
  right_->show_bar(false);
  right_name_->setParent(&left);
  left_.canvas().installEventFilter(this);
  connect(handle_, &SplitHandle::stepped, this, &SplitOverlay::step);
  connect(handle_, &SplitHandle::dragged, this, [this](int x) {
    const QRect canvas = left_.canvas().geometry();
    set_share(static_cast<double>(x - canvas.left()) / std::max(1, canvas.width()));
  });
  for (QWidget* widget : {pane_, static_cast<QWidget*>(right_), static_cast<QWidget*>(handle_),
                          static_cast<QWidget*>(left_name_), right_name_}) {
    widget->show();
  }
  place();
}

SplitOverlay::~SplitOverlay() {
  for (QWidget* widget :
       {pane_, static_cast<QWidget*>(handle_), static_cast<QWidget*>(left_name_), right_name_,
        static_cast<QWidget*>(left_note_), static_cast<QWidget*>(right_note_)}) {
    delete widget;
  }
}

void SplitOverlay::set_share(double share) {
  const double wanted = std::clamp(share, 0.0, 1.0);
  if (wanted != share_) {
    share_ = wanted;
    place();
    emit share_changed(share_);
  }
}

void SplitOverlay::step(int steps) {
  set_share(share_ + steps * share_a_step);
}

void SplitOverlay::set_left_name(const QString& mark) {
  left_name_->setText(mark);
  place();
}

void SplitOverlay::set_notes(const QString& left, const QString& right) {
  left_note_->setText(left);
  right_note_->setText(right);
  left_note_->setVisible(!left.isEmpty());
  right_note_->setVisible(!right.isEmpty());
  place();
}

bool SplitOverlay::eventFilter(QObject* watched, QEvent* event) {
  const bool moved = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  if (watched == &left_.canvas() && moved) {
    place();
  }
  return QObject::eventFilter(watched, event);
}

void SplitOverlay::place() {
  const QRect canvas = left_.canvas().geometry();
  const int x = canvas.left() + static_cast<int>(std::lround(share_ * canvas.width()));
  pane_->setGeometry(x, canvas.top(), canvas.right() + 1 - x, canvas.height());
  right_->setGeometry(canvas.left() - x, 0, canvas.width(), canvas.height());
  handle_->setGeometry(x - handle_width / 2, canvas.top(), handle_width, canvas.height());
  int top = canvas.top() + below_legend;
  const auto put = [&](QWidget& left, QWidget& right) {
    left.adjustSize();
    right.adjustSize();
    const int left_width = std::min(left.width(), std::max(0, x - beside_line - canvas.left()));
    left.setGeometry(x - beside_line - left_width, top, left_width, left.height());
    const int right_width = std::min(right.width(), std::max(0, canvas.right() + 1 - x - beside_line));
    right.setGeometry(x + beside_line, top, right_width, right.height());
    top += std::max(left.height(), right.height()) + 2;
  };
  put(*left_name_, *right_name_);
  put(*left_note_, *right_note_);
  for (QWidget* widget :
       {pane_, static_cast<QWidget*>(left_name_), right_name_, static_cast<QWidget*>(left_note_),
        static_cast<QWidget*>(right_note_), static_cast<QWidget*>(handle_)}) {
    widget->raise();
  }
}

}  // namespace feedscope::ui
