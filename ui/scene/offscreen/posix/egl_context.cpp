#include "ui/scene/offscreen/posix/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "ui/scene/offscreen/posix/shared_library.h"

namespace feedscope::ui {
namespace {

struct Egl {
  Egl() : library({"libEGL.so.1"}) {
    library.find(proc_address, "eglGetProcAddress");
    find(query_string, "eglQueryString");
    find(initialize, "eglInitialize");
    find(bind_api, "eglBindAPI");
    find(choose_config, "eglChooseConfig");
    find(create_context, "eglCreateContext");
    find(destroy_context, "eglDestroyContext");
    find(make_current, "eglMakeCurrent");
    find(current_context, "eglGetCurrentContext");
    // Null if EGL is too old for them.
    query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(proc_address("eglQueryDevicesEXT"));
    query_device_string =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(proc_address("eglQueryDeviceStringEXT"));
    platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(proc_address("eglGetPlatformDisplayEXT"));
  }

  template <typename Function>
  void find(Function*& function, const char* name) {
    library.find(function, name);
  }

  SharedLibrary library;
  __eglMustCastToProperFunctionPointerType (*proc_address)(const char*) = nullptr;
  const char* (*query_string)(EGLDisplay, EGLint) = nullptr;
  EGLBoolean (*initialize)(EGLDisplay, EGLint*, EGLint*) = nullptr;
  EGLBoolean (*bind_api)(EGLenum) = nullptr;
  EGLBoolean (*choose_config)(EGLDisplay, const EGLint*, EGLConfig*, EGLint, EGLint*) = nullptr;
  EGLContext (*create_context)(EGLDisplay, EGLConfig, EGLContext, const EGLint*) = nullptr;
  EGLBoolean (*destroy_context)(EGLDisplay, EGLContext) = nullptr;
  EGLBoolean (*make_current)(EGLDisplay, EGLSurface, EGLSurface, EGLContext) = nullptr;
  EGLContext (*current_context)() = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;
};

const Egl& egl() {
  static const Egl loaded;
  return loaded;
}

bool names(const char* extensions, std::string_view extension) {
  return extensions != nullptr && std::string_view(extensions).find(extension) != std::string_view::npos;
}

/// Mesa's renderer without a GPU; none if EGL does not list devices.
EGLDeviceEXT software_device() {
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (egl().query_devices == nullptr || egl().query_device_string == nullptr ||
      egl().query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) {
    return EGL_NO_DEVICE_EXT;
  }
  for (EGLint i = 0; i < count; ++i) {
    if (names(egl().query_device_string(devices[static_cast<std::size_t>(i)], EGL_EXTENSIONS),
              "EGL_MESA_device_software")) {
      return devices[static_cast<std::size_t>(i)];
    }
  }
  return EGL_NO_DEVICE_EXT;
}

/// Initialized once and never terminated, because other code in the process may use it.
EGLDisplay open_display() {
  if (egl().platform_display == nullptr) {
    throw InputError("EGL: version 1.5 or EGL_EXT_platform_base is needed");
  }
  EGLDisplay display = EGL_NO_DISPLAY;
  if (const EGLDeviceEXT device = software_device(); device != EGL_NO_DEVICE_EXT) {
    display = egl().platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  }
  if (display == EGL_NO_DISPLAY || egl().initialize(display, nullptr, nullptr) == EGL_FALSE) {
    display = egl().platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || egl().initialize(display, nullptr, nullptr) == EGL_FALSE) {
      throw InputError("EGL: no display without a surface (Mesa's libegl-mesa0 has one)");
    }
  }
  if (!names(egl().query_string(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
    throw InputError("EGL: EGL_KHR_surfaceless_context is missing");
  }
  return display;
}

EGLDisplay display() {
  static const EGLDisplay opened = open_display();
  return opened;
}

class EglContext : public OffscreenContext {
 public:
  EglContext() {
    constexpr std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                           EGL_NONE};
    constexpr std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               3,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               2,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    egl().choose_config(display(), wanted.data(), &config, 1, &count);
    egl().bind_api(EGL_OPENGL_API);
    handle_ = count > 0 ? egl().create_context(display(), config, EGL_NO_CONTEXT, attributes.data())
                        : EGL_NO_CONTEXT;
    if (handle_ == EGL_NO_CONTEXT) {
      throw InputError("EGL: no OpenGL 3.2 core context");
    }
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() override { egl().destroy_context(display(), handle_); }

  void make_current() override {
    if (!is_current()) {
      egl().bind_api(EGL_OPENGL_API);
      egl().make_current(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, handle_);
    }
  }
  void release() override { egl().make_current(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  bool is_current() const override { return egl().current_context() == handle_; }

 private:
  EGLContext handle_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_egl_context() {
  return std::make_unique<EglContext>();
}

}  // namespace feedscope::ui
