#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/lessons/lesson.h"

namespace feedscope::test {

namespace fs = std::filesystem;

/// Lessons in a folder of their own that goes away with the test.
class LessonFolder : public testing::Test {
 protected:
  LessonFolder() {
    std::string name = (fs::temp_directory_path() / "feedscope-lesson-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~LessonFolder() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text, const std::string& name = "test.toml") const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  /// good_lesson with its first `from` replaced.
  fs::path changed(const std::string& from, const std::string& to) const {
    std::string text = good_lesson;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return write(text.replace(at, from.size(), to));
  }

  static constexpr const char* good_lesson = R"(title = "Test"
learn = "Something."
minutes = 10
sources = ["Nobody 2020"]
text = "It takes {time} at {feed}."

[start]
program = "lesson_right_angle.nc"
machine = "spinner-mvc850"
model = "essid"
set = ["tolerance=0.1"]

[window]
colour = "cause"
view = "iso"
chart_s = [0.0, 0.5]
runs = [["tolerance=0.2"], ["model=cam"]]

[numbers]
time = { measure = "cycle_time_s", decimals = 2 }
less = { measure = "cycle_time_s", with = ["model=cam"], against = [], as = "percent less" }

[given]
feed = { value = 3000, unit = "mm/min", source = "the program" }

[[question]]
text = "How long?"
with = ["lookahead_blocks=4"]
control = { key = "tolerance", values = [0.05, 0.1] }
watch = { measure = "time_by_cause_s", cause = "axis_jerk" }
hint = "Look."
answer = "{less} less."
[[question.claim]]
measure = "cycle_time_s"
with = ["tolerance=0.2"]
less_than = ["tolerance=0.1"]
[[question.claim]]
measure = "peak_feed_mm_min"
line = 4
about = "feed"
within_percent = 1
[[question.claim]]
measure = "corner_feed_m_min"
line = 4
between = [0.1, 1]
)";

  fs::path folder_;
};

}  // namespace feedscope::test
