#include "ui/scene_view/scene_view.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QApplication>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>
#include <chrono>
#include <cmath>

#include "ui/annotations/annotation_overlay.h"
#include "ui/fields/focus_outline.h"
#include "ui/scene_view/scene_actions.h"
#include "ui/scene_view/scene_canvas.h"
#include "ui/scene_view/scene_texts.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr std::chrono::milliseconds before_hover(60);
constexpr std::chrono::milliseconds before_rest(250);
constexpr double zoom_a_notch = 1.2;
constexpr double notch = 120;  // eighths of a degree
constexpr double zoom_a_pixel = 1.01;

}  // namespace

RenderBackend default_backend() {
  const QString platform = QGuiApplication::platformName();
  const bool headless = platform == "offscreen" || platform == "minimal";
  return headless ? RenderBackend::software : RenderBackend::gpu;
}

SceneView::SceneView(RenderBackend backend, QWidget* parent) : QWidget(parent) {
  make_canvas(backend);
  scene_.set_texts(scene_texts());
  scene_.set_cube(true);
  actions_ = new SceneActions(*this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(actions_->bar());
  layout->addWidget(canvas_, 1);

  hover_timer_.setSingleShot(true);
  hover_timer_.setInterval(before_hover);
  connect(&hover_timer_, &QTimer::timeout, this, &SceneView::hover);
  rest_timer_.setSingleShot(true);
  rest_timer_.setInterval(before_rest);
  connect(&rest_timer_, &QTimer::timeout, this, &SceneView::rest);
  follow_palette();
}

SceneView::~SceneView() {
  canvas_->removeEventFilter(this);  // its overlay is gone before it hides
  delete canvas_;                    // gives VTK's OpenGL objects back while the window still lives
}

void SceneView::make_canvas(RenderBackend backend) {
  window_ = make_render_window(backend);
  scene_.attach(*window_);
  if (backend == RenderBackend::gpu) {
    auto* canvas = new GpuCanvas(*window_, this);
    scene_.on_change([this, canvas] {
      canvas->update();
      follow_scene();
    });
    canvas_ = canvas;
  } else {
    auto* canvas = new SoftwareCanvas(*window_, this);
    scene_.on_change([this, canvas] {
      canvas->request_frame();
      follow_scene();
    });
    canvas_ = canvas;
  }
  canvas_->setFocusPolicy(Qt::StrongFocus);
  canvas_->setMouseTracking(true);
  overlay_ = new AnnotationOverlay(*canvas_, scene_);
  canvas_->installEventFilter(this);
  setFocusProxy(canvas_);
  new FocusOutline(*canvas_, this);
}

void SceneView::follow_scene() {
  overlay_->update();
  emit changed();
  if (actions_ != nullptr) {
    actions_->follow_scene();
  }
}

QList<QAction*> SceneView::panel_actions() const {
  return actions_->all();
}

void SceneView::fill_menu(QMenu& menu) const {
  actions_->fill(menu);
}

void SceneView::show_bar(bool shown) {
  actions_->bar()->setVisible(shown);
}

int SceneView::bar_height() const {
  return actions_->bar()->sizeHint().height();
}

void SceneView::set_bar_height(int height) {
  actions_->bar()->setFixedHeight(height);
}

void SceneView::take_commands_of(const SceneView& other) {
  actions_->keep_own_on_bar();
  for (QAction* command : actions_->commands()) {
    command->setShortcut({});
  }
  addActions(other.actions_->commands());
}

QAction* SceneView::add_to_bar(QWidget& widget) {
  return actions_->bar()->insertWidget(actions_->bar()->actions().value(0), &widget);
}

void SceneView::set_comparable(bool comparable) {
  actions_->set_comparable(comparable);
}

void SceneView::add_comparison_menu(QMenu& menu) {
  actions_->add_comparison_menu(menu);
}

Pixel SceneView::pixel(const QPointF& place) const {
  const double ratio = canvas_->devicePixelRatioF();
  return {place.x() * ratio, place.y() * ratio};
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != canvas_) {
    return QWidget::eventFilter(watched, event);
  }
  if (drag_ == Drag::none && !boxing_ && !measuring_ && overlay_->take(*event)) {
    leave();
    return event->type() != QEvent::MouseButtonPress;  // the widget takes the focus
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      press(*static_cast<QMouseEvent*>(event));
      return false;  // the widget takes the focus
    case QEvent::MouseButtonDblClick:
      scene_.fit();
      return true;
    case QEvent::MouseMove:
      drag(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonRelease:
      release(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::Wheel:
      wheel(*static_cast<QWheelEvent*>(event));
      return true;
    case QEvent::Leave:
      leave();
      return false;
    case QEvent::ShortcutOverride: {
      const bool ours = (measuring_ || boxing_) && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
      event->setAccepted(ours);  // before the window's own use of the key
      return ours;
    }
    case QEvent::KeyPress:
      return key(static_cast<QKeyEvent*>(event)->key());
    default:
      return false;
  }
}

void SceneView::press(const QMouseEvent& mouse) {
  leave();
  pressed_ = last_ = mouse.position();
  dragged_ = false;
  const bool left = mouse.button() == Qt::LeftButton;
  if (left && (boxing_ || mouse.modifiers().testFlag(Qt::ControlModifier))) {
    drag_ = Drag::box;
  } else if (mouse.button() == Qt::MiddleButton || (left && mouse.modifiers().testFlag(Qt::ShiftModifier))) {
    drag_ = Drag::pan;
  } else {
    drag_ = left ? Drag::orbit : Drag::zoom;
  }
  const auto time = drag_ == Drag::orbit ? scene_.pick_time(pixel(pressed_)) : std::nullopt;
  pivot_ = time ? std::optional(scene_.drawn_at(*time)) : std::nullopt;
}

void SceneView::drag(const QMouseEvent& mouse) {
  const QPointF place = mouse.position();
  if (drag_ == Drag::none) {
    last_ = place;
    hover_timer_.start();
    return;
  }
  if (!dragged_ && QLineF(pressed_, place).length() < QApplication::startDragDistance() / 2.0) {
    return;
  }
  dragged_ = true;
  const Pixel from = pixel(last_);
  const Pixel to = pixel(place);
  const Pixel shift{to[0] - from[0], to[1] - from[1]};
  last_ = place;
  scene_.set_moving(drag_ != Drag::box);
  switch (drag_) {
    case Drag::orbit:
      scene_.orbit(shift, pivot_);
      break;
    case Drag::pan:
      scene_.pan(shift);
      break;
    case Drag::zoom:
      scene_.zoom(std::pow(zoom_a_pixel, -shift[1]), pixel(pressed_));
      break;
    case Drag::box:
      scene_.set_rubber_band(std::array{pixel(pressed_), to});
      break;
    case Drag::none:
      break;
  }
}

void SceneView::release(const QMouseEvent& mouse) {
  const Drag was = std::exchange(drag_, Drag::none);
  scene_.set_moving(false);
  if (was == Drag::box) {
    finish_box(mouse.position());
  } else if (!dragged_ && mouse.button() == Qt::LeftButton) {
    click(mouse.position());
  } else if (!dragged_ && mouse.button() == Qt::RightButton) {
    show_menu(mouse);
  }
}

void SceneView::wheel(const QWheelEvent& event) {
  if (event.angleDelta().y() != 0) {
    leave();
    begin_rest();
    scene_.zoom(std::pow(zoom_a_notch, event.angleDelta().y() / notch), pixel(event.position()));
  }
}

bool SceneView::key(int key) {
  if (key != Qt::Key_Escape || !(measuring_ || boxing_)) {
    return false;
  }
  set_measuring(false);
  set_boxing(false);
  return true;
}

void SceneView::click(const QPointF& place) {
  if (const auto view = scene_.cube_view(pixel(place))) {
    scene_.set_standard_view(*view);
    return;
  }
  const auto time = scene_.pick_time(pixel(place));
  if (!time) {
    return;
  }
  if (measuring_) {
    add_measured(*time);
  }
  emit picked(*time);
}

void SceneView::set_measuring(bool measuring) {
  if (measuring == measuring_) {
    return;
  }
  measuring_ = measuring;
  measured_from_.reset();
  scene_.set_dimension(std::nullopt);
  if (measuring) {
    axes_before_ = scene_.axes();
  }
  scene_.set_axes(measuring || axes_before_);
  canvas_->setCursor(measuring ? Qt::CrossCursor : Qt::ArrowCursor);
  emit measuring_changed(measuring);
}

void SceneView::add_measured(double time) {
  if (!measured_from_) {
    measured_from_ = time;
    scene_.set_dimension(SceneDimension{scene_.drawn_at(time), std::nullopt, {}});
    return;
  }
  auto from = scene_.state_at(*measured_from_);
  auto to = scene_.state_at(time);
  if (from && to) {
    if (scene_.on_machine() && scene_.knows_machine()) {
      from->position = scene_.drawn_at(*measured_from_);
      to->position = scene_.drawn_at(time);
    }
    scene_.set_dimension(SceneDimension{scene_.drawn_at(*measured_from_), scene_.drawn_at(time),
                                        measurement_lines(*from, *to)});
  }
  measured_from_.reset();
}

void SceneView::set_boxing(bool boxing) {
  if (boxing == boxing_) {
    return;
  }
  boxing_ = boxing;
  canvas_->setCursor(boxing ? Qt::CrossCursor : Qt::ArrowCursor);
  emit boxing_changed(boxing);
}

void SceneView::finish_box(const QPointF& corner) {
  scene_.set_rubber_band(std::nullopt);
  set_boxing(false);
  if (!dragged_) {
    return;
  }
  const auto times = scene_.times_within(pixel(pressed_), pixel(corner));
  scene_.zoom_to_box(pixel(pressed_), pixel(corner));
  if (times) {
    emit times_chosen((*times)[0], (*times)[1]);
  }
}

void SceneView::choose_visible_times() {
  if (const auto times = scene_.visible_times()) {
    emit times_chosen((*times)[0], (*times)[1]);
  }
}

void SceneView::show_times(double from, double to) {
  const auto duration = scene_.duration();
  const bool all = from <= 1e-9 * duration && to >= (1 - 1e-9) * duration;
  if (!all && drag_ == Drag::none) {  // charts that are zoomed or dragged do not wait for every detail here
    begin_rest();
  }
  scene_.set_highlight(all ? std::nullopt : std::optional(std::array{from, to}));
}

void SceneView::zoom_to_times(double from, double to) {
  scene_.fit_times(from, to);
}

void SceneView::begin_rest() {
  scene_.set_moving(true);
  rest_timer_.start();
}

void SceneView::rest() {
  rest_timer_.stop();
  scene_.set_moving(false);
}

void SceneView::hover() {
  const auto time = scene_.pick_time(pixel(last_));
  const auto state = time ? scene_.state_at(*time) : std::nullopt;
  scene_.set_hover(time ? std::optional(scene_.drawn_at(*time)) : std::nullopt);
  if (state) {
    QStringList lines{hover_text(*state, scene_.contour_error_at(*time))};
    if (const QString more = hover_more_ ? hover_more_(*time) : QString(); !more.isEmpty()) {
      lines.append(more);
    }
    QToolTip::showText(canvas_->mapToGlobal(last_.toPoint()), lines.join('\n'), canvas_);
  } else {
    QToolTip::hideText();
  }
}

void SceneView::leave() {
  hover_timer_.stop();
  scene_.set_hover(std::nullopt);
  QToolTip::hideText();
}

void SceneView::show_menu(const QMouseEvent& mouse) {
  QMenu menu(this);
  if (const auto time = scene_.pick_time(pixel(mouse.position()))) {
    for (QAction* action : place_actions_) {  // they act where the cursor is, which goes there only with them
      QAction* here = menu.addAction(action->icon(), action->text());
      here->setEnabled(action->isEnabled());
      here->setToolTip(action->toolTip());
      connect(here, &QAction::triggered, this, [this, action, place = *time] {
        emit picked(place);
        action->trigger();
      });
    }
    menu.addSeparator();
  }
  actions_->fill(menu);
  menu.exec(mouse.globalPosition().toPoint());
}

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) {
    follow_text_size();
  } else if (event->type() == QEvent::PaletteChange) {
    follow_palette();
  }
  QWidget::changeEvent(event);
}

void SceneView::showEvent(QShowEvent* event) {
  follow_text_size();
  QWidget::showEvent(event);
}

void SceneView::follow_palette() {
  const bool dark = theme_of(palette()) == ThemeKind::dark;
  const Background background = dark ? Background::dark : Background::light;
  scene_.set_background(background);
  overlay_->set_background(background);
}

double SceneView::text_scale() const {
  constexpr double usual_font_pixels = 12;  // 9 points at 96 dots an inch
  return std::max(1.0, QFontInfo(font()).pixelSize() / usual_font_pixels);
}

void SceneView::follow_text_size() {
  const double scale = canvas_->devicePixelRatioF() * text_scale();
  scene_.set_scale(scale);
  overlay_->set_scale(scale);
}

}  // namespace feedscope::ui
