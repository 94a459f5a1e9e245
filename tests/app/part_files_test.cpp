#include "app/part_files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "app/stop_signals.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

TEST(PartFiles, GoWithTheProcessThatASignalEnds) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM}) {
    const fs::path unfinished = fs::temp_directory_path() / "feedscope-unfinished.part";
    const fs::path finished = fs::temp_directory_path() / "feedscope-finished.part";
    std::ofstream(unfinished) << "x";
    std::ofstream(finished) << "x";
    EXPECT_EXIT(
        {
          part_files::remember(unfinished);
          part_files::remember(finished);
          part_files::forget(finished);
          raise(signal);
        },
        testing::KilledBySignal(signal), "");
    EXPECT_FALSE(fs::exists(unfinished)) << signal;
    EXPECT_TRUE(fs::exists(finished)) << signal;
    fs::remove(finished);
  }
}

/// Where work goes on although it was told to end.
TEST(PartFiles, GoWithTheProcessThatEndsItself) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const fs::path unfinished = fs::temp_directory_path() / "feedscope-given-up.part";
  std::ofstream(unfinished) << "x";
  EXPECT_EXIT(
      {
        part_files::remember(unfinished);
        const StopSignals signals;
        raise(SIGTERM);
        signals.wait(-1);
        StopSignals::end_now();
      },
      testing::ExitedWithCode(128 + SIGTERM), "");
  EXPECT_FALSE(fs::exists(unfinished));
}

TEST(PartFiles, LeaveAnIgnoredSignalIgnored) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const fs::path file = fs::temp_directory_path() / "feedscope-kept.part";
  std::ofstream(file) << "x";
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        part_files::remember(file);
        raise(SIGHUP);
        _exit(7);
      },
      testing::ExitedWithCode(7), "");
  EXPECT_TRUE(fs::exists(file));
  fs::remove(file);
}

}  // namespace
}  // namespace feedscope
