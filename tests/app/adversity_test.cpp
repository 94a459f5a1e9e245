#include "tests/app/command_line.h"
#include "tests/support/random_cases.h"
#include "tests/support/sanitized.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <vector>

namespace feedscope::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

/// What the machine may do to a program that writes a file: the old file or the new one is there, never a
/// part.
class Adversity : public CommandLine {
 protected:
  Adversity() {
    std::string zigzag = "G21 G1 F3000\n";
    for (int i = 1; i <= 40; ++i) {
      zigzag += "X" + std::to_string(i) + " Y" + std::to_string(i % 2 * 5) + "\n";
    }
    write("zigzag.nc", zigzag);
    EXPECT_EQ(run("compare zigzag.nc --model essid --sweep tolerance=0.01:0.1:log5 --json study.json").code,
              0);  // leaves 'stderr' too
    fs::permissions(folder_, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                 fs::perms::others_read | fs::perms::others_exec);
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

  /// The file is refused with a message that names it and `reason`, the old one stays and nothing is left
  /// behind.
  void expect_refused(const std::string& call, const std::string& before, const std::string& reason) const {
    write("out", "old");
    const std::vector<std::string> files_before = files();
    const Result result = run(call + " out", before);
    EXPECT_EQ(result.code, 2) << call << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("feedscope: cannot write 'out': " + reason)) << call;
    EXPECT_EQ(contents(folder_ / "out"), "old") << call;
    EXPECT_THAT(files(), UnorderedElementsAreArray(files_before)) << call;
  }

  fs::path part_of(const std::string& name, pid_t process) const {
    return folder_ / (name + "." + std::to_string(process) + ".part");
  }

  /// Starts the program and kills it as soon as what it writes for `name` has `size` bytes; the bytes that it
  /// then had, none if the program ended before.
  std::optional<std::uintmax_t> killed_at(std::uintmax_t size, const std::string& call,
                                          const std::string& name) const {
    const std::string line = std::string("exec ") + no_display + " '" FEEDSCOPE_EXECUTABLE "' " + call + name;
    const pid_t process = fork();
    if (process == 0) {
      const int nowhere = open("/dev/null", O_WRONLY);
      const bool ready = dup2(nowhere, STDOUT_FILENO) >= 0 && dup2(nowhere, STDERR_FILENO) >= 0 &&
                         chdir(folder_.c_str()) == 0;
      if (ready) {
        execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      }
      _exit(125);
    }
    const fs::path part = part_of(name, process);
    std::error_code none;
    while (waitpid(process, nullptr, WNOHANG) == 0) {
      const std::uintmax_t written = fs::file_size(part, none);
      if (!none && written >= size) {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
        const std::uintmax_t left = fs::file_size(part, none);
        fs::remove(part);
        return none ? std::optional<std::uintmax_t>() : left;
      }
      std::this_thread::yield();
    }
    return {};
  }
};

/// Calls that write a file, whose name comes behind: those that need no window, then the others.
const std::vector<std::string> text_outputs{"simulate zigzag.nc --csv",
                                            "simulate zigzag.nc --json",
                                            "simulate zigzag.nc --blends",
                                            "simulate zigzag.nc --contour",
                                            "compare zigzag.nc --model essid --csv",
                                            "compare zigzag.nc --model essid --json",
                                            "compare --merge study.json --csv",
                                            "compare --merge study.json --json",
                                            "check zigzag.nc --json",
                                            "help --man --out",
                                            "help --completion bash --out",
                                            "lessons 1 --format html --out"};
#ifdef FEEDSCOPE_WITH_UI
const std::vector<std::string> drawn_outputs{"compare zigzag.nc --model essid --png",
                                             "render zigzag.nc --size 200x150 --format png --out",
                                             "render zigzag.nc --view charts --format svg --out",
                                             "render zigzag.nc --view window --format png --out",
                                             "render zigzag.nc --view sheet --format pdf --out",
                                             "report zigzag.nc --format pdf --out",
                                             "report zigzag.nc --format html --out",
                                             "lessons 1 --format pdf --out"};
#else
const std::vector<std::string> drawn_outputs;
#endif

std::vector<std::string> all_outputs() {
  std::vector<std::string> all = text_outputs;
  all.insert(all.end(), drawn_outputs.begin(), drawn_outputs.end());
  return all;
}

bool is_root() {
  return geteuid() == 0;
}

bool may_mount() {
  return is_root() && std::system("unshare -m mount -t tmpfs disk /mnt > /dev/null 2>&1") == 0;
}

/// The kinds that ReportCommand.LeavesNothingHalfWrittenOnAFullDisk does not try, on a disk that is really
/// full.
TEST_F(Adversity, KeepsTheOldFileOnAFullDisk) {
  if (!may_mount()) {
    GTEST_SKIP() << "only root may mount a small disk";
  }
  fs::create_directory(folder_ / "disk");
  const std::string full =
      "unshare -m sh -c 'mount -t tmpfs -o size=64k disk disk && printf old > disk/out && "
      "cat /dev/zero 2>/dev/null > disk/filler; \"$@\"; code=$?; ls -A disk > left; cp disk/out kept; "
      "exit $code' sh ";
  for (const std::string call : {"simulate zigzag.nc --blends", "simulate zigzag.nc --contour",
                                 "compare zigzag.nc --model essid --json", "compare --merge study.json --csv",
                                 "compare --merge study.json --json", "check zigzag.nc --json",
                                 "help --man --out", "help --completion bash --out",
#ifdef FEEDSCOPE_WITH_UI
                                 "render zigzag.nc --view window --format png --out"
#endif
       }) {
    const Result result = run(call + " disk/out", full + no_display);
    EXPECT_EQ(result.code, 2) << call << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("feedscope: cannot write 'disk/out': No space left on device")) << call;
    EXPECT_EQ(contents(folder_ / "left"), "filler\nout\n") << call;
    EXPECT_EQ(contents(folder_ / "kept"), "old") << call;
  }
  const Result pages = run("help --html disk", full);
  EXPECT_EQ(pages.code, 2);
  EXPECT_THAT(pages.err, HasSubstr(".html': No space left on device"));
  EXPECT_EQ(contents(folder_ / "left"), "filler\nout\n");
}

/// The system's signal for that would end the process without a word.
TEST_F(Adversity, NamesTheLimitOfAFileSize) {
  const std::string block = "ulimit -f 1; ";
  for (const std::string& call : text_outputs) {
    expect_refused(call, block, "File too large");
  }
  const Result printed = run("simulate zigzag.nc --csv - > printed", block);
  EXPECT_EQ(printed.code, 2);
  EXPECT_THAT(printed.err, HasSubstr("feedscope: cannot write '-': File too large"));
}

/// The first file of each command would fit, the last one does not.
TEST_F(Adversity, WritesAllFilesOfACommandOrNone) {
  for (const std::string call :
       {"simulate zigzag.nc --blends a --csv b", "compare zigzag.nc --model essid --csv a --json b",
        "compare --merge study.json --csv a --json b"}) {
    write("a", "old");
    write("b", "old");
    const std::vector<std::string> before = files();
    const Result result = run(call, "ulimit -f 4; ");
    EXPECT_EQ(result.code, 2) << call;
    EXPECT_THAT(result.err, HasSubstr("feedscope: cannot write 'b': File too large")) << call;
    EXPECT_EQ(contents(folder_ / "a"), "old") << call;
    EXPECT_EQ(contents(folder_ / "b"), "old") << call;
    EXPECT_THAT(files(), UnorderedElementsAreArray(before)) << call;
  }
  const Result pages = run("help --html pages", "ulimit -f 20; ");
  EXPECT_EQ(pages.code, 2);
  EXPECT_THAT(pages.err, HasSubstr(".html': File too large"));
  EXPECT_TRUE(fs::is_empty(folder_ / "pages"));
}

TEST_F(Adversity, LeavesTheOldFileOrTheNewOneWhereItIsKilled) {
  struct Case {
    std::string call;
    int instants;
  };
  constexpr int few = 3;
  std::vector<Case> cases{{"simulate zigzag.nc --step 0.0002 --csv ", test::random_cases(48)},
                          {"simulate zigzag.nc --json ", few},
                          {"compare --merge study.json --csv ", few}};
#ifdef FEEDSCOPE_WITH_UI
  cases.push_back({"render zigzag.nc --size 200x150 --format png --out ", few});
  cases.push_back({"report zigzag.nc --format pdf --out ", few});
  cases.push_back({"report zigzag.nc --format html --out ", few});
#endif
  for (const auto& [call, instants] : cases) {
    const Result result = run(call + "out", no_display);
    ASSERT_EQ(result.code, 0) << call << "\n" << result.err;
    const std::string whole = contents(folder_ / "out");
    const bool is_json = nlohmann::json::accept(whole);  // holds how long it took
    int killed = 0, in_between = 0;
    for (int i = 0; i < instants; ++i) {
      write("out", "old");
      const std::uintmax_t size = whole.size() * static_cast<std::uintmax_t>(i) / (instants - 1);
      const auto left = killed_at(is_json ? std::min<std::uintmax_t>(size, 1) : size, call, "out");
      killed += left ? 1 : 0;
      in_between += left && *left > 0 && *left < whole.size() ? 1 : 0;
      const std::string now = contents(folder_ / "out");
      EXPECT_TRUE(now == "old" || (is_json ? nlohmann::json::accept(now) : now == whole))
          << call << " killed at " << size << " bytes of " << whole.size() << " left " << now.size();
    }
    EXPECT_GT(killed, 0) << call;
    if (instants > few) {
      EXPECT_GT(in_between, instants / 4) << call;
    }
  }
}

/// Work is told to end; what does not notice is ended with the process after 0.9 s.
TEST_F(Adversity, EndsWithinASecondOfASignal) {
  std::string text = "G21 G1 F6000\n";
  for (int i = 0; i < 300'000; ++i) {
    text += "X" + std::to_string(i % 7) + " Y" + std::to_string(i % 5) + "\n";
  }
  write("long.nc", text);
  std::vector<std::string> calls{"simulate long.nc --model optimal --set jerk=on --csv out",
                                 "explain long.nc --model ward --json out", "compare long.nc --json out"};
#ifdef FEEDSCOPE_WITH_UI
  calls.push_back("report long.nc --model essid --format pdf --out out");
#endif
  for (const std::string& call : calls) {
    write("out", "old");
    const std::vector<std::string> before = files();
    const auto begin = std::chrono::steady_clock::now();
    const Result result = run(call, std::string(no_display) + " timeout --preserve-status --signal=TERM 1");
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(result.code, 143) << call << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("feedscope: cancelled; no file was written")) << call;
    EXPECT_EQ(contents(folder_ / "out"), "old") << call;
    EXPECT_THAT(files(), UnorderedElementsAreArray(before)) << call;
    constexpr double busy_machine = 1;  // [s]
    EXPECT_LT(taken.count(), 1 + 1 + busy_machine) << call;
  }
}

TEST_F(Adversity, SaysWhereAFolderIsClosed) {
  const std::string nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups ";
  if (!is_root() || run("--version", nobody).code != 0) {
    GTEST_SKIP() << "only root may become another user, who must find the program";
  }
  write("out", "old");
  for (const auto& [file, allowed] : {std::pair{"closed", fs::perms::owner_all}, {"open", fs::perms::all}}) {
    fs::permissions(folder_ / "out", allowed & ~fs::perms(0111));
    for (const std::string& call : all_outputs()) {
      SCOPED_TRACE(file);
      expect_refused(call, nobody + no_display, "Permission denied");
    }
  }
}

TEST_F(Adversity, NeedsNoHome) {
  const std::string none =
      "env -u XDG_CONFIG_HOME -u XDG_CACHE_HOME -u XDG_DATA_HOME -u XDG_STATE_HOME -u XDG_RUNTIME_DIR "
      "-u MESA_SHADER_CACHE_DIR "
      "-u XDG_CONFIG_DIRS -u XDG_DATA_DIRS ";
  std::vector<std::pair<std::string, std::string>> calls;
  for (const std::string& call : all_outputs()) {
    calls.emplace_back("-u HOME ", call);
  }
  for (std::size_t i = 0; i < drawn_outputs.size(); ++i) {
    if (test::in_turn(i)) {
      calls.emplace_back("HOME=/nonexistent ", drawn_outputs[i]);
    }
  }
  for (const auto& [home, call] : calls) {
    fs::remove(folder_ / "out");
    const Result result = run(call + " out", none + home + no_display);
    EXPECT_EQ(result.code, 0) << home << call;
    EXPECT_EQ(result.err, "") << home << call;
    EXPECT_GT(contents(folder_ / "out").size(), 100u) << home << call;
  }
}

/// The limit is met by the system's loader (127), by the program or by a library that draws.
TEST_F(Adversity, SaysWhereMemoryRunsOut) {
  if (sanitized) {
    GTEST_SKIP() << "a sanitizer takes more than any limit";
  }
  std::string text = "G21 G1 F3000\n";
  for (int i = 1; i <= 120000; ++i) {
    text += "X" + std::to_string(i % 100) + " Y" + std::to_string(i % 7) + "\n";
  }
  write("large.nc", text);
  struct Case {
    std::string call;
    std::vector<int> limits;  // [MB]
  };
  const std::vector<int> of_program{150, 180, 200, 220, 250, 400, 1000};
  std::vector<Case> cases{{"simulate large.nc --blends out", of_program},
                          {"compare large.nc --model essid --csv out", of_program}};
#ifdef FEEDSCOPE_WITH_UI
  const std::vector<int> of_picture{150, 300, 450, 500, 550, 600, 700, 800, 900, 1000};
  cases.push_back({"render corner.nc --size 200x150 --format png --out out", of_picture});
  cases.push_back({"report corner.nc --format pdf --out out", of_picture});
#endif
  for (const auto& [call, limits] : cases) {
    ASSERT_EQ(run(call, no_display).code, 0) << call;
    const std::string whole = contents(folder_ / "out");
    int refused = 0;
    for (std::size_t i = 0; i < limits.size(); i += test::thorough() ? 1 : 2) {
      const int limit = limits[i];
      SCOPED_TRACE(call + " within " + std::to_string(limit) + " MB");
      write("out", "old");
      const std::vector<std::string> before = files();
      const Result result =
          run(call, "ulimit -v " + std::to_string(limit * 1024) + "; ulimit -c 0; timeout 120 " + no_display);
      EXPECT_THAT(result.code, AnyOf(0, 3, 127)) << result.err;
      EXPECT_TRUE(contents(folder_ / "out") == (result.code == 0 ? whole : "old"));
      EXPECT_THAT(files(), UnorderedElementsAreArray(before));
      if (result.code == 3) {
        EXPECT_THAT(result.err, HasSubstr("feedscope: out of memory"));
        ++refused;
      }
    }
    EXPECT_GT(refused, 0) << call << ": no limit was met while it ran";
  }
}

}  // namespace
}  // namespace feedscope::test
