#pragma once

#include <fmt/format.h>

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/analysis/run/run.h"
#include "ui/workbench/trace_list.h"

namespace feedscope::test {

/// What a control would have recorded of a run: a table with a head, one row each 2 ms, shifted in X.
inline std::string trace_table(const Run& run, double shift = 12.5) {
  std::string text = "time [s],x [mm],y [mm],z [mm]\n";
  const MotionRecord record = record_of(*run.trajectory, 2e-3);
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const Vec3& place = record.place[i];
    text +=
        fmt::format("{:.6f},{:.5f},{:.5f},{:.5f}\n", record.time[i], place.x() + shift, place.y(), place.z());
  }
  return text;
}

/// Files that go with the test.
class WrittenFiles {
 public:
  WrittenFiles() {}  // so that a const one needs no value
  std::filesystem::path write(const char* name, const std::string& text) const {
    const std::filesystem::path file = std::filesystem::path(folder_.path().toStdString()) / name;
    std::ofstream(file) << text;
    return file;
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace feedscope::test
