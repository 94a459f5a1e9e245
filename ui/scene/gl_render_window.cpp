#include "ui/scene/gl_render_window.h"

#include <vtkObjectFactory.h>
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

}  // namespace feedscope::ui
