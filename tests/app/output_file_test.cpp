#include "app/output_file.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "core/base/error.h"

namespace {

int fsync_error = 0;   // of the next calls; 0: as the system does
int fclose_error = 0;  // of the next calls; 0: as the system does
int fsync_calls = 0;

}  // namespace

// In front of the system's: a disk that fails late.
extern "C" int fsync(int descriptor) {
  ++fsync_calls;
  if (fsync_error != 0) {
    errno = fsync_error;
    return -1;
  }
  static auto* const system = reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"));
  return system(descriptor);
}

extern "C" int fclose(FILE* file) {
  static auto* const system = reinterpret_cast<int (*)(FILE*)>(dlsym(RTLD_NEXT, "fclose"));
  const int result = system(file);
  if (fclose_error != 0) {
    errno = fclose_error;
    return EOF;
  }
  return result;
}

namespace feedscope {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() {
    std::string name = (fs::temp_directory_path() / "feedscope-output-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    std::ofstream(file()) << "old";
    fsync_calls = 0;
  }
  ~OutputFileTest() override {
    fsync_error = fclose_error = 0;
    fs::remove_all(folder_);
  }

  fs::path file() const { return folder_ / "out"; }
  std::string contents() const {
    std::ostringstream text;
    text << std::ifstream(file()).rdbuf();
    return text.str();
  }
  std::ptrdiff_t count() const { return std::distance(fs::directory_iterator(folder_), {}); }

  /// Writes the file, and gives the message if that fails.
  std::string write_new() const {
    OutputFile out(file().string());
    out.stream() << "new";
    try {
      out.commit();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(OutputFileTest, ReachesTheDiskBeforeItsPlace) {
  EXPECT_EQ(write_new(), "");
  EXPECT_EQ(fsync_calls, 1);
  EXPECT_EQ(contents(), "new");
  EXPECT_EQ(count(), 1);
}

TEST_F(OutputFileTest, KeepsTheOldFileWhereTheDiskFailsLate) {
  fsync_error = EIO;
  EXPECT_THAT(write_new(), HasSubstr("cannot write '" + file().string() + "': Input/output error"));
  EXPECT_EQ(contents(), "old");
  EXPECT_EQ(count(), 1);
}

TEST_F(OutputFileTest, KeepsTheOldFileWhereItsEndIsRefused) {
  fclose_error = EDQUOT;
  EXPECT_THAT(write_new(), HasSubstr("cannot write '" + file().string() + "': Disk quota exceeded"));
  fclose_error = 0;
  EXPECT_EQ(contents(), "old");
  EXPECT_EQ(count(), 1);
}

TEST_F(OutputFileTest, AFinishedFileIsNotYetAtItsPlace) {
  {
    OutputFile given_up(file().string());
    given_up.stream() << "new";
    given_up.finish();
    EXPECT_EQ(contents(), "old");
  }
  EXPECT_EQ(contents(), "old");
  EXPECT_EQ(count(), 1);
  OutputFile out(file().string());
  out.stream() << "new";
  out.finish();
  fsync_error = EIO;  // the work is done: what fails now is too late
  out.commit();
  EXPECT_EQ(contents(), "new");
}

TEST_F(OutputFileTest, SeveralFilesReachTheirPlacesTogetherOrNotAtAll) {
  const std::string other = (folder_ / "other").string();
  {
    OutputFiles refused;
    refused.add(file().string()) << "new";
    refused.add(other) << "new";
    refused.add("/dev/full") << "new";
    EXPECT_THROW(refused.commit(), InputError);
  }
  EXPECT_EQ(contents(), "old");
  EXPECT_EQ(count(), 1);
  OutputFiles both;
  both.add(file().string()) << "new";
  both.add(other) << "new";
  both.commit();
  EXPECT_EQ(contents(), "new");
  EXPECT_EQ(count(), 2);
}

/// Long texts fail while they are written, before anybody asks for the reason.
TEST_F(OutputFileTest, KeepsTheReasonOfTheFirstFailure) {
  OutputFile out("/dev/full");
  out.stream() << std::string(100000, 'x');
  errno = 0;
  out.stream() << "more";
  try {
    out.commit();
    ADD_FAILURE() << "a full device took everything";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "cannot write '/dev/full': No space left on device");
  }
}

TEST_F(OutputFileTest, DoesWithoutOnAFileSystemThatCannotBeAsked) {
  for (const int error : {EINVAL, ENOTSUP}) {
    fsync_error = error;
    std::ofstream(file()) << "old";
    EXPECT_EQ(write_new(), "");
    EXPECT_EQ(contents(), "new");
  }
}

TEST_F(OutputFileTest, WritesDevicesDirectly) {
  fsync_error = EIO;
  OutputFile out("/dev/null");
  out.stream() << "new";
  EXPECT_NO_THROW(out.commit());
  EXPECT_EQ(fsync_calls, 0);
}

}  // namespace
}  // namespace feedscope
