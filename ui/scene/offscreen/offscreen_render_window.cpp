#include "ui/scene/offscreen/offscreen_render_window.h"

#include <vtkObjectFactory.h>
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
}

OffscreenRenderWindow::~OffscreenRenderWindow() {
  if (context_ != nullptr) {
    this->MakeCurrent();
    this->Finalize();
    this->ReleaseCurrent();
  }
}

void OffscreenRenderWindow::MakeCurrent() {
  constexpr int unset_size = 300;  // as in VTK's own windows
  context_->make_current(this->Size[0] > 0 ? this->Size[0] : unset_size,
                         this->Size[1] > 0 ? this->Size[1] : unset_size);
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
