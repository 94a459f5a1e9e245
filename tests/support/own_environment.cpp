// Linked into everything that tests: the same fonts, settings, locale, time zone and screen on every machine.
// A test on a display or at another scale names it in QT_QPA_PLATFORM or QT_SCALE_FACTOR.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "tests/support/folders.h"

namespace {

namespace fs = std::filesystem;

/// A folder without settings, removed with the process.
class OwnFolder {
 public:
  OwnFolder() {
    path_ = (fs::temp_directory_path() / "feedscope-test-XXXXXX").string();
    if (mkdtemp(path_.data()) == nullptr) {
      std::abort();
    }
    for (const char* const place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
      setenv(place, (fs::path(path_) / place).c_str(), 1);
    }
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

 private:
  std::string path_;
};

const bool set_up = [] {
  for (const char* const of_the_desktop :
       {"LANG", "LANGUAGE", "LC_CTYPE", "LC_NUMERIC", "LC_TIME", "LC_MESSAGES", "XDG_CURRENT_DESKTOP",
        "XDG_SESSION_TYPE", "DESKTOP_SESSION", "KDE_FULL_SESSION", "QT_QPA_PLATFORMTHEME",
        "QT_STYLE_OVERRIDE", "QT_FONT_DPI", "FEEDSCOPE_DATA"}) {
    unsetenv(of_the_desktop);
  }
  if (std::getenv("QT_QPA_PLATFORM") == nullptr) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
  }
  setenv("LC_ALL", "C.UTF-8", 1);
  setenv("TZ", "UTC", 1);
  setenv("FONTCONFIG_FILE", FEEDSCOPE_BINARY_DIR "/tests/fonts.conf", 1);
  setenv("MESA_SHADER_CACHE_DIR", FEEDSCOPE_BINARY_DIR "/shaders", 0);
  return true;
}();
const OwnFolder settings;

}  // namespace
