#include "ui/scene/osmesa_render_window.h"

#include <vtkObjectFactory.h>
#include <vtkVersionMacros.h>
#include <vtk_glew.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#error \
    "VTK 9.4 and later draw without a display by vtkOSOpenGLRenderWindow: make_render_window() should use it"
#endif

#define GLAPI extern  // osmesa.h needs it, glew.h has undefined it
#include <GL/osmesa.h>

// The part of libglvnd's dispatcher (libGLdispatch.so.0, ABI version 1) used here; no package has its header.
extern "C" {
struct GlDispatchThreadState {
  int tag;
  void (*thread_destroyed)(GlDispatchThreadState*);
  void* reserved;
};
using GlDispatchProc = void (*)();
int __glDispatchGetABIVersion(void);
void __glDispatchInit(void);
int __glDispatchNewVendorID(void);
void* __glDispatchCreateTable(GlDispatchProc (*find)(const char*, void*), void* parameter);
unsigned char __glDispatchMakeCurrent(GlDispatchThreadState*, void* table, int vendor, const void* patches);
void __glDispatchLoseCurrent(void);
GlDispatchThreadState* __glDispatchGetCurrentThreadState(void);
}

namespace feedscope::ui {
namespace {

/// OSMesa as a vendor of the dispatcher; one a process, because vendors cannot be taken back.
class OsmesaVendor {
 public:
  static OsmesaVendor& instance() {
    static OsmesaVendor vendor;
    return vendor;
  }

  bool current() const { return __glDispatchGetCurrentThreadState() == &state_; }
  void make_current() {
    if (current()) {
      return;
    }
    if (__glDispatchGetCurrentThreadState() != nullptr) {
      __glDispatchLoseCurrent();
    }
    __glDispatchMakeCurrent(&state_, table_, vendor_, nullptr);
  }
  void release() {
    if (current()) {
      __glDispatchLoseCurrent();
    }
  }

 private:
  OsmesaVendor() {
    if (__glDispatchGetABIVersion() != 1) {
      throw std::runtime_error("OSMesa: libGLdispatch has ABI version " +
                               std::to_string(__glDispatchGetABIVersion()) + ", version 1 is needed");
    }
    __glDispatchInit();
    vendor_ = __glDispatchNewVendorID();
    table_ = __glDispatchCreateTable(
        [](const char* name, void*) { return reinterpret_cast<GlDispatchProc>(OSMesaGetProcAddress(name)); },
        nullptr);
  }

  static constexpr int neither_glx_nor_egl = 2;
  GlDispatchThreadState state_{neither_glx_nor_egl, [](GlDispatchThreadState*) {}, nullptr};
  int vendor_ = 0;
  void* table_ = nullptr;
};

}  // namespace

struct OsmesaRenderWindow::Context {
  OSMesaContext handle = nullptr;
  std::vector<unsigned char> pixels;  ///< OSMesa draws its default frame buffer here, RGBA
};

vtkStandardNewMacro(OsmesaRenderWindow);

OsmesaRenderWindow::OsmesaRenderWindow() : context_(std::make_unique<Context>()) {
  OsmesaVendor::instance();
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            2,
                            0};
  context_->handle = OSMesaCreateContextAttribs(attributes, nullptr);
  if (context_->handle == nullptr) {
    throw std::runtime_error("OSMesa: no OpenGL 3.2 core context; Mesa 12 or later (libosmesa6) is needed");
  }
  this->SetReadyForRendering(true);
  this->SetMapped(true);
  this->SetOwnContext(true);
  this->SetUseOffScreenBuffers(true);
  this->SetShowWindow(false);
}

OsmesaRenderWindow::~OsmesaRenderWindow() {
  if (context_->handle == nullptr) {
    return;
  }
  this->MakeCurrent();
  this->Finalize();
  this->ReleaseCurrent();
  OSMesaDestroyContext(context_->handle);
}

void OsmesaRenderWindow::MakeCurrent() {
  constexpr int unset_size = 300;  // as VTK's own windows
  const int width = this->Size[0] > 0 ? this->Size[0] : unset_size;
  const int height = this->Size[1] > 0 ? this->Size[1] : unset_size;
  const std::size_t bytes =
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (OSMesaGetCurrentContext() != context_->handle || context_->pixels.size() != bytes) {
    context_->pixels.resize(bytes);
    OSMesaMakeCurrent(context_->handle, context_->pixels.data(), GL_UNSIGNED_BYTE, width, height);
  }
  OsmesaVendor::instance().make_current();
}

void OsmesaRenderWindow::ReleaseCurrent() {
  OsmesaVendor::instance().release();
  OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
}

bool OsmesaRenderWindow::IsCurrent() {
  return OSMesaGetCurrentContext() == context_->handle && OsmesaVendor::instance().current();
}

}  // namespace feedscope::ui
