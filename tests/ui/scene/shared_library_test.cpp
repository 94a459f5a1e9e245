#include "ui/scene/offscreen/posix/shared_library.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"

namespace feedscope::ui {
namespace {

namespace fs = std::filesystem;

std::string refusal(std::initializer_list<const char*> names) {
  try {
    const SharedLibrary library(names);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SharedLibrary, NamesTheFirstOfThoseThatAreNotInstalled) {
  EXPECT_EQ(refusal({"libfeedscope-none.so.2", "libfeedscope-none.so.1"}),
            "libfeedscope-none.so.2 is not installed");
}

/// Lack of memory is tried on the whole program, where there is no sanitizer:
/// Adversity.SaysWhereMemoryRunsOut.
TEST(SharedLibrary, SaysWhyOneThatIsThereCannotBeLoaded) {
  const fs::path file = fs::temp_directory_path() / ("feedscope-no-library." + std::to_string(getpid()));
  std::ofstream(file) << std::string(1000, 'x');
  EXPECT_EQ(refusal({"libfeedscope-none.so.2", file.c_str()}),
            file.string() + " cannot be loaded (" + file.string() + ": invalid ELF header)");
  fs::remove(file);
}

}  // namespace
}  // namespace feedscope::ui
