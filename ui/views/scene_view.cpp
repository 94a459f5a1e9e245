#include "ui/views/scene_view.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QApplication>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QVBoxLayout>

#include "ui/views/scene_canvas.h"

namespace feedscope::ui {

RenderBackend default_backend() {
  const QString platform = QGuiApplication::platformName();
  const bool headless = platform == "offscreen" || platform == "minimal";
  return headless ? RenderBackend::software : RenderBackend::gpu;
}

struct SceneView::Vtk {
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
};

SceneView::SceneView(RenderBackend backend, QWidget* parent)
    : QWidget(parent), vtk_(std::make_unique<Vtk>()) {
  vtk_->window = make_render_window(backend);
  scene_.attach(*vtk_->window);
  vtk_->interactor->SetRenderWindow(vtk_->window);
  vtk_->interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
  vtk_->interactor->Initialize();
  vtk_->interactor->EnableRenderOff();  // Qt says when to draw; VTK's wish for a frame becomes an update

  std::function<void()> redraw;
  if (backend == RenderBackend::gpu) {
    auto* canvas = new GpuCanvas(*vtk_->window, *vtk_->interactor, this);
    redraw = [canvas] { canvas->update(); };
    canvas_ = canvas;
  } else {
    auto* canvas = new SoftwareCanvas(*vtk_->window, *vtk_->interactor, this);
    redraw = [canvas] { canvas->request_frame(); };
    canvas_ = canvas;
  }
  scene_.on_change(redraw);
  const vtkNew<vtkCallbackCommand> wish;
  wish->SetClientData(new std::function<void()>(redraw));
  wish->SetClientDataDeleteCallback([](void* call) { delete static_cast<std::function<void()>*>(call); });
  wish->SetCallback(
      [](vtkObject*, unsigned long, void* call, void*) { (*static_cast<std::function<void()>*>(call))(); });
  vtk_->interactor->AddObserver(vtkCommand::RenderEvent, wish);

  canvas_->setFocusPolicy(Qt::StrongFocus);
  canvas_->installEventFilter(this);
  setFocusProxy(canvas_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(canvas_);
}

SceneView::~SceneView() {
  delete canvas_;  // gives VTK's OpenGL objects back while the window still lives
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == canvas_ && event->type() == QEvent::MouseButtonPress) {
    pressed_ = static_cast<QMouseEvent*>(event)->position();
  } else if (watched == canvas_ && event->type() == QEvent::MouseButtonRelease) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const double moved = QLineF(pressed_, mouse->position()).length();
    if (mouse->button() == Qt::LeftButton && moved < QApplication::startDragDistance() / 2.0) {
      click(mouse->position());
    }
  }
  return QWidget::eventFilter(watched, event);
}

void SceneView::click(const QPointF& place) {
  const double ratio = canvas_->devicePixelRatioF();
  if (const auto time = scene_.pick_time({place.x() * ratio, place.y() * ratio})) {
    emit picked(*time);
  }
}

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) {
    follow_text_size();
  }
  QWidget::changeEvent(event);
}

void SceneView::showEvent(QShowEvent* event) {
  follow_text_size();
  QWidget::showEvent(event);
}

void SceneView::follow_text_size() {
  constexpr double usual_font_pixels = 12;  // 9 points at 96 dots an inch
  const double font_pixels = QFontInfo(font()).pixelSize();
  scene_.set_scale(canvas_->devicePixelRatioF() * std::max(1.0, font_pixels / usual_font_pixels));
}

}  // namespace feedscope::ui
