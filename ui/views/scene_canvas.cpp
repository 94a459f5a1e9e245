#include "ui/views/scene_canvas.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkUnsignedCharArray.h>

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QSurfaceFormat>
#include <cmath>

namespace feedscope::ui {
namespace {

int pixels(int logical, const QWidget& widget) {
  return static_cast<int>(std::lround(logical * widget.devicePixelRatioF()));
}

void resize_window(vtkGenericOpenGLRenderWindow& window, vtkRenderWindowInteractor& interactor,
                   const QSize& size) {
  interactor.UpdateSize(size.width(), size.height());
  window.SetSize(size.width(), size.height());
}

}  // namespace

bool pass_to_interactor(QEvent& event, const QWidget& widget, vtkRenderWindowInteractor& interactor) {
  const auto place = [&](const QSinglePointEvent& at) {
    const double ratio = widget.devicePixelRatioF();
    interactor.SetEventInformation(static_cast<int>(at.position().x() * ratio),
                                   static_cast<int>((widget.height() - 1 - at.position().y()) * ratio),
                                   at.modifiers().testFlag(Qt::ControlModifier) ? 1 : 0,
                                   at.modifiers().testFlag(Qt::ShiftModifier) ? 1 : 0);
  };
  const auto button = [&](unsigned long left, unsigned long middle, unsigned long right) {
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    place(mouse);
    const unsigned long name = mouse.button() == Qt::LeftButton     ? left
                               : mouse.button() == Qt::MiddleButton ? middle
                                                                    : right;
    interactor.InvokeEvent(name);
  };
  switch (event.type()) {
    case QEvent::MouseMove:
      place(static_cast<const QMouseEvent&>(event));
      interactor.InvokeEvent(vtkCommand::MouseMoveEvent);
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      button(vtkCommand::LeftButtonPressEvent, vtkCommand::MiddleButtonPressEvent,
             vtkCommand::RightButtonPressEvent);
      return true;
    case QEvent::MouseButtonRelease:
      button(vtkCommand::LeftButtonReleaseEvent, vtkCommand::MiddleButtonReleaseEvent,
             vtkCommand::RightButtonReleaseEvent);
      return true;
    case QEvent::Wheel: {
      const auto& wheel = static_cast<const QWheelEvent&>(event);
      place(wheel);
      if (wheel.angleDelta().y() != 0) {
        interactor.InvokeEvent(wheel.angleDelta().y() > 0 ? vtkCommand::MouseWheelForwardEvent
                                                          : vtkCommand::MouseWheelBackwardEvent);
      }
      return true;
    }
    default:
      return false;
  }
}

GpuCanvas::GpuCanvas(vtkGenericOpenGLRenderWindow& window, vtkRenderWindowInteractor& interactor,
                     QWidget* parent)
    : QOpenGLWidget(parent), window_(window), interactor_(interactor) {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  setFormat(format);
}

GpuCanvas::~GpuCanvas() {
  release();
}

void GpuCanvas::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
  window_.SetReadyForRendering(true);
  window_.SetIsCurrent(true);
  window_.SetSupportsOpenGL(1);
  window_.SetMapped(true);
  window_.SetOwnContext(false);
}

void GpuCanvas::release() {
  if (!window_.GetReadyForRendering()) {
    return;
  }
  makeCurrent();
  window_.Finalize();
  window_.SetReadyForRendering(false);
  doneCurrent();
}

void GpuCanvas::resizeGL(int width, int height) {
  resize_window(window_, interactor_, {pixels(width, *this), pixels(height, *this)});
}

void GpuCanvas::paintGL() {
  window_.Render();  // VTK copies its picture into the frame buffer that Qt has bound
  // Where VTK has blended, alpha is below 1, and Qt would let what lies behind the widget through.
  QOpenGLFunctions& gl = *context()->functions();
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.glClearColor(0, 0, 0, 1);
  gl.glClear(GL_COLOR_BUFFER_BIT);
  gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

bool GpuCanvas::event(QEvent* event) {
  return pass_to_interactor(*event, *this, interactor_) || QOpenGLWidget::event(event);
}

SoftwareCanvas::SoftwareCanvas(vtkGenericOpenGLRenderWindow& window, vtkRenderWindowInteractor& interactor,
                               QWidget* parent)
    : QWidget(parent), window_(window), interactor_(interactor) {
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void SoftwareCanvas::request_frame() {
  image_ = QImage();
  update();
}

QSize SoftwareCanvas::pixel_size() const {
  return {pixels(width(), *this), pixels(height(), *this)};
}

void SoftwareCanvas::resizeEvent(QResizeEvent*) {
  resize_window(window_, interactor_, pixel_size());
  request_frame();
}

void SoftwareCanvas::paintEvent(QPaintEvent*) {
  if (image_.isNull() || image_.size() != pixel_size()) {
    if (auto* other = QOpenGLContext::currentContext()) {
      other->doneCurrent();
    }
    resize_window(window_, interactor_, pixel_size());
    window_.Render();
    const int* size = window_.GetSize();
    const vtkNew<vtkUnsignedCharArray> pixel_data;
    window_.GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixel_data, 0);
    window_.ReleaseCurrent();
    image_ =
        QImage(pixel_data->GetPointer(0), size[0], size[1], size[0] * 3, QImage::Format_RGB888).mirrored();
  }
  QPainter(this).drawImage(rect(), image_);
}

bool SoftwareCanvas::event(QEvent* event) {
  return pass_to_interactor(*event, *this, interactor_) || QWidget::event(event);
}

}  // namespace feedscope::ui
