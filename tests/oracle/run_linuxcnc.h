#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

#include "tests/support/folders.h"

namespace feedscope::test {

/// Exit code of run_linuxcnc where there is no LinuxCNC to run: see packaging/oracle.
inline constexpr int no_linuxcnc = 77;

/// Runs programs on LinuxCNC with a configuration of this folder, "linuxcnc" or "table"; the exit code.
inline int run_linuxcnc(const std::string& configuration, const std::filesystem::path& trace,
                        std::span<const std::filesystem::path> programs) {
  std::string line = fmt::format("'{}/tests/oracle/run_linuxcnc' {} '{}'", FEEDSCOPE_SOURCE_DIR,
                                 configuration, trace.string());
  for (const std::filesystem::path& program : programs) {
    line += fmt::format(" '{}'", program.string());
  }
  const int status = std::system(line.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace feedscope::test
