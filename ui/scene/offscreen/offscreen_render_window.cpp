#include "ui/scene/offscreen/offscreen_render_window.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkVersionMacros.h>

#include <algorithm>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#error \
    "VTK 9.4 and later draw without a display by vtkOSOpenGLRenderWindow: make_render_window() should use it"
#endif

namespace feedscope::ui {

vtkStandardNewMacro(OffscreenRenderWindow);

OffscreenRenderWindow::OffscreenRenderWindow() {
  this->SetReadyForRendering(true);
  this->SetMapped(true);
  this->SetOwnContext(true);
  this->SetUseOffScreenBuffers(true);
  this->SetShowWindow(false);
  this->SwapBuffersOff();
}

OffscreenRenderWindow::~OffscreenRenderWindow() {
  if (context_ != nullptr) {
    this->MakeCurrent();
    this->Finalize();
    this->ReleaseCurrent();
  }
}

void OffscreenRenderWindow::Start() {
  GlRenderWindow::Start();
  // Pictures are read from the frame buffer that VTK draws into; nothing shows or reads these copies of it.
  this->DisplayFramebuffer->RemoveColorAttachments(2);
  this->DisplayFramebuffer->RemoveDepthAttachment();
  this->ResolveFramebuffer->RemoveDepthAttachment();
}

void OffscreenRenderWindow::MakeCurrent() {
  context_->make_current();
}

void OffscreenRenderWindow::ReleaseCurrent() {
  context_->release();
}

int OffscreenRenderWindow::GetColorBufferSizes(int* rgba) {
  constexpr int bits = 8;
  std::fill_n(rgba, 4, bits);
  return 4 * bits;
}

bool OffscreenRenderWindow::IsCurrent() {
  return context_->is_current();
}

}  // namespace feedscope::ui
