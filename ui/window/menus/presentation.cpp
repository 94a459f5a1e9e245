#include "ui/window/menus/presentation.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>
#include <cmath>

#include "ui/program_text/program_view.h"
#include "ui/scene_view/scene_view.h"
#include "ui/shared/panel_action.h"
#include "ui/theme/type_size.h"
#include "ui/window/panels/dock_sizes.h"

namespace feedscope::ui {

namespace {

constexpr QSize reference(1280, 800);      // a projector's window, with a font of
constexpr double reference_scale = 1.5;    // times the usual size
constexpr double lesson_column = 22 * 12;  // [px at the usual font size]: 30 to 40 letters in a line
constexpr double most_for_lesson = 0.36;   // of the width
constexpr double charts_share = 0.45;      // of the height

}  // namespace

Presentation::Presentation(QMainWindow& window, DockSizes& sizes, const Parts& parts)
    : QObject(&window), window_(window), sizes_(sizes), parts_(parts) {
  make_actions();
  window_.installEventFilter(this);
  resized_.setSingleShot(true);
  resized_.setInterval(0);
  connect(&resized_, &QTimer::timeout, this, &Presentation::follow_size);
}

Presentation::~Presentation() {
  if (on_) {
    TypeSize::of_application().set_scale(1);
  }
}

void Presentation::make_actions() {
  action_ = make_action(&window_, tr("&Presentation"),
                        tr("Large type and the open lesson alone, with its 3D view and charts: for a class"),
                        QKeySequence(Qt::Key_F12));
  action_->setCheckable(true);
  set_everyday_words(action_, tr("class projector beamer large type bigger letters teach"));
  connect(action_, &QAction::toggled, this, &Presentation::set_on);
  full_screen_ = make_action(&window_, tr("F&ull screen"), tr("Use the whole screen, without a frame"),
                             QKeySequence(Qt::Key_F11));
  full_screen_->setCheckable(true);
  connect(full_screen_, &QAction::triggered, this, [this](bool full) {
    window_.setWindowState(full ? window_.windowState() | Qt::WindowFullScreen
                                : window_.windowState() & ~Qt::WindowFullScreen);
  });
  const auto add_step = [this](const QString& text, const QString& tip, Qt::Key key, bool forward) {
    QAction* step = make_action(&window_, text, tip, QKeySequence(key));
    step->setEnabled(false);
    connect(step, &QAction::triggered, this, [this, forward] { emit step_wanted(forward); });
    return step;
  };
  next_ = add_step(tr("&Next step"), tr("While presenting: next question or answer of the lesson"),
                   Qt::Key_PageDown, true);
  previous_ =
      add_step(tr("Pre&vious step"), tr("While presenting: previous question or answer of the lesson"),
               Qt::Key_PageUp, false);
}

double Presentation::type_scale(const QSize& window) {
  constexpr double step = 0.05;
  constexpr double smallest = 0.6;
  constexpr double largest = 6;
  const double share = std::min(static_cast<double>(window.width()) / reference.width(),
                                static_cast<double>(window.height()) / reference.height());
  return std::clamp(std::round(reference_scale * share / step) * step, smallest, largest);
}

QByteArray Presentation::usual_layout() const {
  return on_ ? usual_layout_ : window_.saveState();
}

int Presentation::usual_program_type() const {
  return on_ ? usual_program_type_ : parts_.program.font_size();
}

void Presentation::set_on(bool on) {
  if (on == on_) {
    return;
  }
  on ? enter() : leave();
  action_->setChecked(on);
  next_->setEnabled(on);
  previous_->setEnabled(on);
  emit switched(on);
}

void Presentation::show_over(const QByteArray& usual_layout) {
  set_on(true);
  if (!usual_layout.isEmpty()) {
    usual_layout_ = usual_layout;
  }
}

void Presentation::enter() {
  usual_layout_ = window_.saveState();
  usual_size_ = window_.size();
  usual_program_type_ = parts_.program.font_size();
  on_ = true;
  sizes_.set_paused(true);
  for (QToolBar* bar : window_.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
    if (!bar->isHidden()) {
      bars_.push_back(bar);
      bar->hide();
    }
  }
  window_.menuBar()->setMaximumHeight(0);  // if hidden, its commands would lose their keys
  window_.statusBar()->hide();
  parts_.scene.show_bar(false);
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
    dock->setVisible(dock == &parts_.lesson || dock == &parts_.charts);
  }
  parts_.lesson.setFloating(false);
  parts_.charts.setFloating(false);
  window_.addDockWidget(Qt::RightDockWidgetArea, &parts_.lesson);
  window_.addDockWidget(Qt::BottomDockWidgetArea, &parts_.charts);
  // Lets a large window with large type shrink to a small one, where type is small again.
  constexpr QSize smallest(320, 240);
  window_.setMinimumSize(smallest);
  follow_size();
}

void Presentation::leave() {
  const QSize size = window_.size();
  on_ = false;
  TypeSize::of_application().set_scale(1);
  parts_.program.set_font_size(usual_program_type_);
  for (QWidget* bar : bars_) {
    bar->show();
  }
  bars_.clear();
  window_.menuBar()->setMaximumHeight(QWIDGETSIZE_MAX);
  window_.statusBar()->show();
  parts_.scene.show_bar(true);
  window_.setMinimumSize(0, 0);
  window_.restoreState(usual_layout_);
  // Large type may have requested more room for a moment: the window keeps its size.
  window_.resize(size);
  QTimer::singleShot(0, this, [this, size] { settle(size); });
}

/// Called when the usual font size has been restored.
void Presentation::settle(const QSize& size) {
  if (on_) {
    return;
  }
  if (!window_.isMaximized() && !window_.isFullScreen()) {
    window_.resize(size);
  }
  window_.restoreState(usual_layout_);
  sizes_.set_paused(false);
  if (size != usual_size_) {
    sizes_.follow_layout();
  }
}

void Presentation::follow_size() {
  if (!on_) {
    return;
  }
  const double scale = type_scale(window_.size());
  TypeSize::of_application().set_scale(scale);
  parts_.program.set_font_size(static_cast<int>(std::lround(usual_program_type_ * scale)));
  share_out();
  QTimer::singleShot(0, this, &Presentation::share_out);  // after the layout for larger type
}

void Presentation::share_out() {
  if (!on_) {
    return;
  }
  const double column =
      std::min(lesson_column * TypeSize::of_application().scale(), most_for_lesson * window_.width());
  window_.resizeDocks({&parts_.lesson}, {static_cast<int>(column)}, Qt::Horizontal);
  window_.resizeDocks({&parts_.charts}, {static_cast<int>(charts_share * window_.height())}, Qt::Vertical);
}

bool Presentation::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::Resize && on_) {
    resized_.start();
  } else if (watched == &window_ && event->type() == QEvent::WindowStateChange) {
    full_screen_->setChecked(window_.isFullScreen());
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace feedscope::ui
