#include "ui/scene_view/scene_canvas.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QSurfaceFormat>
#include <cmath>

#include "ui/scene/render_window.h"

namespace feedscope::ui {
namespace {

int pixels(int logical, const QWidget& widget) {
  return static_cast<int>(std::lround(logical * widget.devicePixelRatioF()));
}

}  // namespace

GpuCanvas::GpuCanvas(vtkGenericOpenGLRenderWindow& window, QWidget* parent)
    : QOpenGLWidget(parent), window_(window) {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  setFormat(format);
  // Outside of a frame VTK requests the context to release buffers.
  const auto observe = [&](unsigned long event, void (*call)(vtkObject*, unsigned long, void*, void*)) {
    const vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(call);
    return window_.AddObserver(event, command);
  };
  make_current_ =
      observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
        auto& canvas = *static_cast<GpuCanvas*>(self);
        if (!canvas.is_current()) {
          canvas.makeCurrent();
        }
      });
  ask_current_ =
      observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
        *static_cast<bool*>(answer) = static_cast<GpuCanvas*>(self)->is_current();
      });
}

GpuCanvas::~GpuCanvas() {
  release();
  window_.RemoveObserver(make_current_);
  window_.RemoveObserver(ask_current_);
}

bool GpuCanvas::is_current() const {
  return context() != nullptr && QOpenGLContext::currentContext() == context();
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
  window_.SetSize(pixels(width, *this), pixels(height, *this));
}

void GpuCanvas::paintGL() {
  window_.Render();  // VTK copies its picture into the frame buffer bound by Qt
  // After blending by VTK, alpha is below 1, and Qt would show what is under the widget.
  QOpenGLFunctions& gl = *context()->functions();
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.glClearColor(0, 0, 0, 1);
  gl.glClear(GL_COLOR_BUFFER_BIT);
  gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

SoftwareCanvas::SoftwareCanvas(vtkGenericOpenGLRenderWindow& window, QWidget* parent)
    : QWidget(parent), window_(window) {
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void SoftwareCanvas::request_frame() {
  drawn_ = false;
  update();
}

QSize SoftwareCanvas::pixel_size() const {
  return {pixels(width(), *this), pixels(height(), *this)};
}

void SoftwareCanvas::resizeEvent(QResizeEvent*) {
  window_.SetSize(pixel_size().width(), pixel_size().height());
  request_frame();
}

void SoftwareCanvas::paintEvent(QPaintEvent*) {
  if (!drawn_ || image_.size() != pixel_size()) {
    if (auto* other = QOpenGLContext::currentContext()) {
      other->doneCurrent();
    }
    window_.SetSize(pixel_size().width(), pixel_size().height());
    window_.Render();
    const QSize size(window_.GetSize()[0], window_.GetSize()[1]);
    if (image_.size() != size) {
      image_ = QImage(size, QImage::Format_RGBX8888);
    }
    read_frame(window_, [this](int y) { return image_.scanLine(y); });
    window_.ReleaseCurrent();
    drawn_ = true;
  }
  QPainter(this).drawImage(rect(), image_);
}

}  // namespace feedscope::ui
