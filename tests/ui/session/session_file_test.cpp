#include "ui/session/session_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/folders.h"
#include "tests/ui/session/some_session.h"
#include "ui/session/session_json.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class SessionFile : public testing::Test {
 protected:
  std::filesystem::path in_folder(const char* name) const {
    return std::filesystem::path(folder_.path().toStdString()) / name;
  }
  std::string failure_of(const std::string& text) const {
    const auto file = in_folder("bad.feedscope");
    std::ofstream(file) << text;
    try {
      read_session_file(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  QTemporaryDir folder_;
};

TEST_F(SessionFile, IsReadBackFromTheDisk) {
  const Session session = some_session(in_folder("part.nc"));
  write_session(session, in_folder("a.feedscope"));
  const ReadSession read = read_session_file(in_folder("a.feedscope"));
  EXPECT_EQ(read.session.program, session.program);
  EXPECT_EQ(read.session.annotations, session.annotations);
}

TEST_F(SessionFile, TheSameSessionIsTheSameBytes) {
  const Session session = some_session("/a.nc");
  EXPECT_EQ(session_bytes(session, "/"), session_bytes(session, "/"));
}

TEST_F(SessionFile, BrokenJsonIsNamedWithItsPlace) {
  EXPECT_THAT(failure_of("{\n  \"format\": 1,\n  oops\n}"),
              AllOf(HasSubstr("bad.feedscope"), HasSubstr("line 3")));
  EXPECT_THAT(failure_of(""), HasSubstr("is not a session"));
  EXPECT_THAT(failure_of("[]"), HasSubstr("not a Feedscope session"));
}

TEST_F(SessionFile, AMissingOneIsNamed) {
  EXPECT_THROW(read_session_file(in_folder("none.feedscope")), InputError);
}

TEST_F(SessionFile, WhereItCannotBeWrittenNothingIsLeft) {
  const auto file = in_folder("no") / "such" / "a.feedscope";
  EXPECT_THROW(write_session(some_session("/a.nc"), file), InputError);
  EXPECT_FALSE(std::filesystem::exists(in_folder("no")));
}

TEST_F(SessionFile, AFailedWriteLeavesWhatWasThere) {
  const auto file = in_folder("a.feedscope");
  std::filesystem::create_directory(file);  // cannot be replaced by a file
  EXPECT_THROW(write_session(some_session("/a.nc"), file), InputError);
  EXPECT_TRUE(std::filesystem::is_directory(file));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
}

TEST_F(SessionFile, HashesBytes) {
  std::ofstream(in_folder("a.nc")) << "abc";
  EXPECT_EQ(hash_of(in_folder("a.nc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");  // FIPS 180-2, B.1
  EXPECT_TRUE(hash_of(in_folder("none.nc")).isEmpty());
}

/// The schema is compared with this file.
TEST_F(SessionFile, IsAsTheOneThatIsHeldAgainstItsSchema) {
  const std::filesystem::path folder = FEEDSCOPE_SOURCE_DIR "/tests/ui/session";
  std::ifstream in(folder / "everything.feedscope");
  const std::string held{std::istreambuf_iterator<char>(in), {}};
  const std::string now = session_bytes(some_session(folder / "part.nc"), folder).toStdString();
  if (now != held) {
    std::ofstream("everything.feedscope") << now;
  }
  EXPECT_TRUE(now == held) << "compare it with " << std::filesystem::absolute("everything.feedscope")
                           << ", written by this test";
}

/// One file for each version is kept as it was written then.
TEST_F(SessionFile, OfEveryVersionIsReadWhole) {
  const std::filesystem::path folder = FEEDSCOPE_SOURCE_DIR "/tests/ui/session/versions";
  Session expected = some_session(folder / "part.nc");
  // These came later.
  expected.load = {};
  expected.error_bound = std::nullopt;
  expected.traces.clear();
  expected.identification = {};
  expected.lessons = {};
  expected.lessons_unlocked = false;
  expected.charts.hidden_charts.clear();
  expected.charts.shown_charts.clear();
  expected.scene.stretch = {};
  expected.scene.on_machine = false;
  expected.scene.axes = true;  // they were always drawn
  expected.presentation = false;
  for (int version = 1; version <= session_version; ++version) {
    const ReadSession read =
        read_session_file(folder / ("version_" + std::to_string(version) + ".feedscope"));
    EXPECT_TRUE(read.notes.isEmpty()) << version;
    EXPECT_EQ(session_bytes(read.session, folder), session_bytes(expected, folder)) << version;
  }
}

}  // namespace
}  // namespace feedscope::ui
