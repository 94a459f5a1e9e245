#include "ui/scene/gl_render_window.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkVersionMacros.h>
#include <vtk_glew.h>

#include <string_view>

namespace feedscope::ui {

vtkStandardNewMacro(GlRenderWindow);

void GlRenderWindow::OpenGLInitContext() {
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  // Up to VTK 9.3 the base class treats GLEW's "no GLX display" as a failure and gives up, although GLEW
  // loads all entry points before it searches an X display. VTK 9.4 loads GL without GLEW.
  this->ContextCreationTime.Modified();
  if (this->Initialized) {
    return;
  }
  this->MakeCurrent();
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
  if (!this->GlewInitValid || !GLEW_VERSION_3_2) {
    vtkErrorMacro("OpenGL 3.2 is required");
    return;
  }
  this->Initialized = true;
  float range[2] = {1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
#else
  vtkGenericOpenGLRenderWindow::OpenGLInitContext();
#endif
}

void GlRenderWindow::Start() {
  vtkGenericOpenGLRenderWindow::Start();
  // The context has the GL_LESS of OpenGL and Qt; VTK draws flat shapes on top of each other at one depth.
  this->GetState()->vtkglDepthFunc(GL_LEQUAL);
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name != nullptr ? name : "";
  software_ = renderer.starts_with("llvmpipe") || renderer.starts_with("softpipe");
}

void GlRenderWindow::Frame() {
  if (!software_ || !this->SwapBuffers) {
    vtkGenericOpenGLRenderWindow::Frame();
    return;
  }
  // VTK smooths edges by a shader and copies depths, twice, which takes the processor longer than coarse
  // paths.
  vtkOpenGLState& state = *this->GetState();
  state.PushFramebufferBindings();
  this->RenderFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->RenderFramebuffer->ActivateReadBuffer(0);
  this->DisplayFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->DisplayFramebuffer->ActivateDrawBuffer(0);
  state.vtkglDisable(GL_SCISSOR_TEST);
  const int* size = this->GetSize();
  state.vtkglBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state.PopFramebufferBindings();
  this->BlitDisplayFramebuffer();
  this->InvokeEvent(vtkCommand::WindowFrameEvent, nullptr);
}

}  // namespace feedscope::ui
