#include "ui/scene/offscreen/offscreen_context.h"

#include <windows.h>

#include <array>

#include "core/base/error.h"

namespace feedscope::ui {
namespace {

// From WGL_ARB_create_context and WGL_ARB_create_context_profile, whose header no package has.
constexpr int context_major_version = 0x2091;
constexpr int context_minor_version = 0x2092;
constexpr int context_profile = 0x9126;
constexpr int core_profile = 1;
using CreateContext = HGLRC(WINAPI*)(HDC device, HGLRC shared, const int* attributes);

/// A window that is never shown: OpenGL of Windows needs the device of one.
class HiddenWindow {
 public:
  HiddenWindow() {
    const wchar_t* const name = L"Feedscope OpenGL";
    WNDCLASSW kind{};
    kind.style = CS_OWNDC;
    kind.lpfnWndProc = DefWindowProcW;
    kind.hInstance = GetModuleHandleW(nullptr);
    kind.lpszClassName = name;
    RegisterClassW(&kind);  // fails for the second window, whose class is there
    window_ = CreateWindowExW(0, name, name, WS_POPUP, 0, 0, 1, 1, nullptr, nullptr, kind.hInstance, nullptr);
    device_ = GetDC(window_);
    PIXELFORMATDESCRIPTOR format{};
    format.nSize = sizeof(format);
    format.nVersion = 1;
    format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL;
    format.iPixelType = PFD_TYPE_RGBA;
    format.cColorBits = 24;
    SetPixelFormat(device_, ChoosePixelFormat(device_, &format), &format);
  }
  HiddenWindow(const HiddenWindow&) = delete;
  HiddenWindow& operator=(const HiddenWindow&) = delete;
  ~HiddenWindow() {
    ReleaseDC(window_, device_);
    DestroyWindow(window_);
  }
  HDC device() const { return device_; }

 private:
  HWND window_ = nullptr;
  HDC device_ = nullptr;
};

class WglContext : public OffscreenContext {
 public:
  WglContext() {
    constexpr std::array attributes{context_major_version, 3, context_minor_version, 2, context_profile,
                                    core_profile,          0};
    const HGLRC first = wglCreateContext(window_.device());  // of any version: needed to find the function
    wglMakeCurrent(window_.device(), first);
    const auto create = reinterpret_cast<CreateContext>(
        reinterpret_cast<void*>(wglGetProcAddress("wglCreateContextAttribsARB")));
    handle_ = create != nullptr ? create(window_.device(), nullptr, attributes.data()) : nullptr;
    wglMakeCurrent(nullptr, nullptr);
    wglDeleteContext(first);
    if (handle_ == nullptr) {
      throw InputError("pictures need OpenGL 3.2, which this computer's graphics driver does not offer");
    }
  }
  WglContext(const WglContext&) = delete;
  WglContext& operator=(const WglContext&) = delete;
  ~WglContext() override { wglDeleteContext(handle_); }

  void make_current() override {
    if (!is_current()) {
      wglMakeCurrent(window_.device(), handle_);
    }
  }
  void release() override { wglMakeCurrent(nullptr, nullptr); }
  bool is_current() const override { return wglGetCurrentContext() == handle_; }

 private:
  HiddenWindow window_;
  HGLRC handle_ = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_offscreen_context() {
  return std::make_unique<WglContext>();
}

}  // namespace feedscope::ui
