#include "ui/scene/offscreen/posix/osmesa_context.h"

#include <array>
#include <string>

#include "core/base/error.h"
#include "ui/scene/offscreen/posix/shared_library.h"

// The part of libglvnd's dispatcher (libGLdispatch.so.0, ABI version 1) used here; no package contains its
// header.
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

// From GL/osmesa.h, which Mesa 25.1 and later lack.
constexpr int osmesa_rgba = 0x1908;
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_stencil_bits = 0x31;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;
constexpr unsigned osmesa_unsigned_byte = 0x1401;

using Handle = struct osmesa_context*;

struct Osmesa {
  Osmesa() : library({"libOSMesa.so.8", "libOSMesa.so.6"}) {
    library.find(create, "OSMesaCreateContextAttribs");
    library.find(destroy, "OSMesaDestroyContext");
    library.find(make_current, "OSMesaMakeCurrent");
    library.find(current, "OSMesaGetCurrentContext");
    library.find(proc_address, "OSMesaGetProcAddress");
  }

  SharedLibrary library;
  Handle (*create)(const int* attributes, Handle shared) = nullptr;
  void (*destroy)(Handle) = nullptr;
  unsigned char (*make_current)(Handle, void* pixels, unsigned type, int width, int height) = nullptr;
  Handle (*current)() = nullptr;
  GlDispatchProc (*proc_address)(const char* name) = nullptr;
};

const Osmesa& osmesa() {
  static const Osmesa loaded;
  return loaded;
}

/// OSMesa as a vendor of the dispatcher; one in a process, because vendors cannot be removed.
class Vendor {
 public:
  static Vendor& instance() {
    static Vendor vendor;
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
  Vendor() {
    if (__glDispatchGetABIVersion() != 1) {
      throw InputError("OSMesa: libGLdispatch has ABI version " +
                       std::to_string(__glDispatchGetABIVersion()) + ", version 1 is needed");
    }
    __glDispatchInit();
    vendor_ = __glDispatchNewVendorID();
    table_ =
        __glDispatchCreateTable([](const char* name, void*) { return osmesa().proc_address(name); }, nullptr);
  }

  static constexpr int neither_glx_nor_egl = 2;
  GlDispatchThreadState state_{neither_glx_nor_egl, [](GlDispatchThreadState*) {}, nullptr};
  int vendor_ = 0;
  void* table_ = nullptr;
};

class OsmesaContext : public OffscreenContext {
 public:
  OsmesaContext() {
    osmesa();
    Vendor::instance();
    constexpr std::array attributes{osmesa_format,
                                    osmesa_rgba,
                                    osmesa_depth_bits,
                                    24,
                                    osmesa_stencil_bits,
                                    8,
                                    osmesa_profile,
                                    osmesa_core_profile,
                                    osmesa_major_version,
                                    3,
                                    osmesa_minor_version,
                                    2,
                                    0};
    handle_ = osmesa().create(attributes.data(), nullptr);
    if (handle_ == nullptr) {
      throw InputError("OSMesa: no OpenGL 3.2 core context; Mesa 12 or later is needed");
    }
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;
  ~OsmesaContext() override { osmesa().destroy(handle_); }

  void make_current() override {
    if (osmesa().current() != handle_) {
      osmesa().make_current(handle_, pixel_.data(), osmesa_unsigned_byte, 1, 1);
    }
    Vendor::instance().make_current();
  }

  void release() override {
    Vendor::instance().release();
    osmesa().make_current(nullptr, nullptr, 0, 0, 0);
  }

  bool is_current() const override { return osmesa().current() == handle_ && Vendor::instance().current(); }

 private:
  Handle handle_ = nullptr;
  std::array<unsigned char, 4> pixel_{};  // OSMesa's default frame buffer, RGBA
};

}  // namespace

std::unique_ptr<OffscreenContext> make_osmesa_context() {
  return std::make_unique<OsmesaContext>();
}

}  // namespace feedscope::ui
