#pragma once

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace feedscope::test {

namespace fs = std::filesystem;

/// In front of a command: there is no display.
inline constexpr const char* no_display = "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM";

struct Result {
  int code = -1;
  std::string out;
  std::string err;
};

inline std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Runs the executable as people do, in a folder of its own.
class CommandLine : public testing::Test {
 protected:
  CommandLine() {
    std::string name = (fs::temp_directory_path() / "feedscope-cli-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    write("corner.nc", "G21 G1 X20 F3000\nY20\n");
    write("wrong.nc", "G21 G1 X20 F3000\nfoo\nY20\n");
  }
  ~CommandLine() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// `arguments` as on a shell line, quotes and redirections included; `before` stands before the executable.
  Result run(const std::string& arguments, const std::string& before = "") const {
    const fs::path err = folder_ / "stderr";
    const std::string line = "cd '" + folder_.string() + "' && " + before + " '" FEEDSCOPE_EXECUTABLE "' " +
                             arguments + " 2>stderr";
    Result result;
    FILE* pipe = popen(line.c_str(), "r");
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
      result.out.append(buffer.data(), n);
    }
    const int status = pclose(pipe);
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.err = contents(err);
    return result;
  }

  /// The call must fail as wrong use, print nothing on standard output, and say `message`.
  void expect_wrong_use(const std::string& arguments, const std::string& message) const {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_THAT(result.err, testing::AllOf(testing::StartsWith("feedscope: "), testing::HasSubstr(message)))
        << arguments;
  }

  fs::path folder_;
};

}  // namespace feedscope::test
