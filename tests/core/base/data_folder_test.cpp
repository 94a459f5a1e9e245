#include "core/base/data_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

/// FEEDSCOPE_DATA for the time of a test.
class DataFolder : public testing::Test {
 protected:
  ~DataFolder() override {
    unsetenv("FEEDSCOPE_DATA");
    fs::remove_all(folder_);
  }
  const fs::path folder_ = fs::temp_directory_path() / ("feedscope-data-" + std::to_string(getpid()));
};

TEST_F(DataFolder, IsTheSourceTreeWhereNothingIsInstalled) {
  unsetenv("FEEDSCOPE_DATA");
  EXPECT_EQ(data_folder(), fs::path(FEEDSCOPE_SOURCE_DIR));
}

TEST_F(DataFolder, IsWhatTheEnvironmentSays) {
  fs::create_directories(folder_ / "machines");
  setenv("FEEDSCOPE_DATA", folder_.c_str(), 1);
  EXPECT_EQ(data_folder(), folder_);
}

TEST_F(DataFolder, OfTheEnvironmentMustHoldMachines) {
  setenv("FEEDSCOPE_DATA", "/nowhere", 1);
  EXPECT_THROW(data_folder(), InputError);
}

}  // namespace
}  // namespace feedscope
