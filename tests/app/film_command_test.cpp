#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "tests/app/command_line.h"
#include "ui/scene/picture.h"

namespace feedscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// `feedscope render --film` in a folder of its own, without any display.
class FilmCommand : public CommandLine {
 protected:
  FilmCommand() {
    write("turn.nc", "G21 G90 G94 F3000\nG1 X20 Y0\nG1 X40 Y15\nG2 X60 Y15 I10 J0\nG1 X60 Y60\nM30\n");
    fs::create_directory(folder_ / "frames");
  }

  Result film(const std::string& arguments) const { return run("render turn.nc " + arguments, no_display); }
  std::set<std::string> files(const std::string& folder = "frames") const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / folder)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
  void expect_refused(const std::string& arguments, const std::string& message) const {
    const Result result = film(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.err, testing::AllOf(StartsWith("feedscope: "), HasSubstr(message))) << arguments;
    EXPECT_THAT(files(), testing::IsEmpty()) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "a.ogv")) << arguments;
  }
};

TEST_F(FilmCommand, WritesThePicturesOfAStretch) {
  const std::string call = "--from 0.2 --to 0.8 --speed 0.5 --fps 5 --size 320x240 --charts --film ";
  const Result result = film(call + "frames/%03d.png");
  EXPECT_EQ(result.code, 2) << "no room for charts";
  const std::string larger = "--from 0.2 --to 0.8 --speed 0.5 --fps 5 --size 800x600 --charts --film ";
  ASSERT_EQ(film(larger + "frames/%03d.png").code, 0);
  EXPECT_THAT(files(),
              ElementsAre("000.png", "001.png", "002.png", "003.png", "004.png", "005.png", "006.png"));
  const auto picture = ui::read_png((folder_ / "frames/003.png").string());
  EXPECT_EQ(picture.size.width, 800);
  EXPECT_EQ(picture.size.height, 600);
  fs::create_directory(folder_ / "again");
  ASSERT_EQ(film(larger + "again/%03d.png").code, 0);
  for (const std::string& name : files()) {
    EXPECT_EQ(contents(folder_ / "frames" / name), contents(folder_ / "again" / name)) << name;
  }
  EXPECT_NE(contents(folder_ / "frames/001.png"), contents(folder_ / "frames/002.png"));
}

TEST_F(FilmCommand, TheStartOfAFilmDoesNotDependOnItsEnd) {
  const std::string call = "--speed 1 --fps 10 --trail 0.2 --size 320x240 --film ";
  ASSERT_EQ(film(call + "frames/a%d.png --from 0.3 --to 0.6").code, 0);
  ASSERT_EQ(film(call + "frames/b%d.png --from 0.5 --to 0.9").code, 0);
  EXPECT_EQ(contents(folder_ / "frames/a2.png"), contents(folder_ / "frames/b0.png")) << "0.5 s of the run";
}

TEST_F(FilmCommand, FilmsTheWholeRunAtASpeedThatCanBeWatched) {
  ASSERT_EQ(film("--fps 1 --size 320x240 --film frames/%d.png").code, 0);
  const std::size_t seconds = files().size();
  EXPECT_GE(seconds, 6u) << "a run of about 3 s is slowed down";
  EXPECT_LE(seconds, 8u);
}

TEST_F(FilmCommand, WritesAVideo) {
  const Result result = film("--from 0 --to 0.5 --speed 1 --fps 10 --size 320x240 --film a.OGV");
  if (result.err.find("no IOOggTheora") != std::string::npos) {
    GTEST_SKIP() << result.err;
  }
  EXPECT_EQ(result.code, 0) << result.err;
  const std::string bytes = contents(folder_ / "a.OGV");
  EXPECT_THAT(bytes, StartsWith("OggS"));
  const std::size_t header = bytes.find("\x80theora");
  ASSERT_NE(header, std::string::npos);
  const auto number = [&](std::size_t at) {
    return 65536 * static_cast<unsigned char>(bytes[header + at]) +
           256 * static_cast<unsigned char>(bytes[header + at + 1]) +
           static_cast<unsigned char>(bytes[header + at + 2]);
  };
  EXPECT_EQ(number(14), 320);
  EXPECT_EQ(number(17), 240);
}

TEST_F(FilmCommand, TellsItsProgressInLines) {
  const Result result =
      film("--from 0 --to 1 --speed 1 --fps 5 --size 320x240 --progress --film frames/%d.png");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("progress: drawing "));
}

/// Told to end in the middle of drawing, by what a window that cancels it sends.
TEST_F(FilmCommand, LeavesNothingWhenItIsStopped) {
  for (const std::string name : {"frames/%d.png", "frames/a.ogv"}) {
    const std::string line = "cd '" + folder_.string() + "'; " + no_display +
                             " '" FEEDSCOPE_EXECUTABLE
                             "' render turn.nc --speed 0.001 --fps 10 --size 320x240 --progress --film " +
                             name +
                             " 2>said & film=$!; for i in $(seq 3000); do grep -q drawing said && break; "
                             "kill -0 $film || break; sleep 0.02; done; ls -A frames > begun; "
                             "kill -TERM $film; wait $film";
    write("said", "");
    const int status = std::system(line.c_str());
    EXPECT_NE(status, 0);
    if (contents(folder_ / "said").find("no IOOggTheora") == std::string::npos) {
      EXPECT_THAT(contents(folder_ / "begun"), HasSubstr(".part")) << contents(folder_ / "said");
    }
    EXPECT_THAT(files(), testing::IsEmpty()) << name;
  }
}

TEST_F(FilmCommand, NotesPicturesOfAnOlderFilm) {
  write("frames/2.png", "old");
  const Result result = film("--from 0 --to 0.1 --speed 1 --fps 10 --size 320x240 --film frames/%d.png");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("note: 'frames/2.png' is of an older film"));
}

TEST_F(FilmCommand, RefusesTimesThatMakeNoFilm) {
  const std::string out = " --film frames/%d.png";
  expect_refused("--from 2 --to 1" + out, "--from 2 is not before --to 1");
  expect_refused("--from 1 --to 1" + out, "--from 1 is not before --to 1");
  expect_refused("--to 1000" + out, "the run takes");
  expect_refused("--from 1000" + out, "give --from a time before");
  expect_refused("--from -1" + out, "--from");
  for (const std::string fps : {"0", "121", "2.5", "-1", "many"}) {
    expect_refused("--fps " + fps + out, "--fps");
  }
  for (const std::string speed : {"0", "-1", "nan", "inf", "1e400", "fast"}) {
    expect_refused("--speed " + speed + out, "--speed");
  }
  expect_refused("--trail -1" + out, "--trail");
  expect_refused("--speed 0.001" + out, "at most 36000 can be written; use --speed");
}

TEST_F(FilmCommand, RefusesFilesThatItCannotWrite) {
  expect_refused("--film frames/a.png", "needs a number in its name");
  expect_refused("--film frames/%s.png", "frames/%05d.png");
  expect_refused("--film frames/a.mp4", "end the name in .ogv");
  expect_refused("--film -", "end the name in .ogv");
  expect_refused("--film none/%d.png", "there is no folder");
  expect_refused("--film none/a.ogv", "none/a.ogv");
  expect_refused("--film turn.nc", "it is the program itself");
  expect_refused("--film a.ogv --size 321x240", "use --size 320x240");
  if (geteuid() != 0) {
    fs::create_directory(folder_ / "locked");
    fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expect_refused("--film locked/%d.png", "Permission denied");
    expect_refused("--film locked/a.ogv", "Permission denied");
  }
  fs::create_directory_symlink("/proc/self/task", folder_ / "proc");
  expect_refused("--film proc/%d.png", "cannot write 'proc/%d.png'");
}

TEST_F(FilmCommand, RefusesWhatDoesNotGoWithAFilmOrOnlyWithOne) {
  expect_refused("", "give --out FILE for a picture, or --film FILE for a film");
  for (const std::string option :
       {"--out a.png", "--view charts", "--format png", "--dpi 100", "--title x", "--transparent"}) {
    const std::string name = option.substr(0, option.find(' '));
    expect_refused(option + " --film frames/%d.png", name + " has no effect on a film");
  }
  for (const std::string option : {"--from 1", "--to 1", "--speed 1", "--fps 1", "--trail 1", "--charts"}) {
    const std::string name = option.substr(0, option.find(' '));
    expect_refused(option + " --out a.png", name + " has no effect without --film");
  }
  expect_refused("--size A4 --film frames/%d.png", "a film has pixels");
}

}  // namespace
}  // namespace feedscope::test
