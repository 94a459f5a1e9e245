#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "ui/scene/picture.h"

namespace {

namespace fs = std::filesystem;
using feedscope::ui::read_png;
using testing::HasSubstr;

/// There is no display.
constexpr const char* no_display = "env -u DISPLAY -u WAYLAND_DISPLAY";

struct Result {
  int code = -1;
  std::string err;
};

/// Runs `feedscope render` in a folder of its own, without any display.
class RenderCommand : public testing::Test {
 protected:
  RenderCommand() {
    std::string name = (fs::temp_directory_path() / "feedscope-render-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    std::ofstream(folder_ / "corner.nc") << "G21 G1 X20 F3000\nY20\n";
    std::ofstream(folder_ / "wrong.nc") << "G21 G1 X20 F3000\nfoo\nY20\n";
  }
  ~RenderCommand() override { fs::remove_all(folder_); }

  Result run(const std::string& arguments) const {
    const std::string line = "cd '" + folder_.string() + "' && " + no_display +
                             " '" FEEDSCOPE_EXECUTABLE "' render " + arguments + " 2>stderr";
    const int status = std::system(line.c_str());
    std::ostringstream err;
    err << std::ifstream(folder_ / "stderr").rdbuf();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, err.str()};
  }

  void expect_wrong_use(const std::string& arguments, const std::string& message) const {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(message)) << arguments;
  }

  fs::path folder_;
};

TEST_F(RenderCommand, WritesAPictureOfTheSizeAskedFor) {
  for (const std::string camera : {"iso", "top", "front", "right"}) {
    const Result result =
        run("corner.nc --view 3d --size 500x400 --camera " + camera + " --out " + camera + ".png");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const auto picture = read_png((folder_ / (camera + ".png")).string());
    EXPECT_EQ(picture.size.width, 500);
    EXPECT_EQ(picture.size.height, 400);
  }
}

TEST_F(RenderCommand, WritesEveryViewInEveryFormat) {
  for (const std::string view : {"3d", "charts", "window", "sheet"}) {
    const std::string size = view == "window" ? "--size 1280x800" : "--size A4 --dpi 72";
    for (const std::string format : {"png", "svg", "pdf"}) {
      const Result result = run("corner.nc --view " + view + " " + size + " --out " + view + "." + format);
      EXPECT_EQ(result.code, 0) << view << format << result.err;
      const std::string start = format == "png" ? "\x89PNG" : format == "svg" ? "<?xml" : "%PDF-";
      std::ostringstream bytes;
      bytes << std::ifstream(folder_ / (view + "." + format), std::ios::binary).rdbuf();
      EXPECT_THAT(bytes.str(), testing::StartsWith(start));
    }
  }
}

TEST_F(RenderCommand, ColoursTheFirstRunAgainstAnother) {
  const std::string runs = "corner.nc --tolerance 0.01 --tolerance 0.05 --tolerance 0.1 --size 400x300 ";
  const auto picture = [&](const std::string& options) {
    const Result result = run(runs + options + " --out a.png");
    EXPECT_EQ(result.code, 0) << result.err;
    return read_png((folder_ / "a.png").string()).rgb;
  };
  const auto lost = picture("--colour time_lost");
  EXPECT_EQ(lost, picture("--colour time_lost --reference 2"));
  EXPECT_NE(lost, picture("--colour time_lost --reference 3"));
  EXPECT_NE(lost, picture("--colour path_distance"));
  EXPECT_EQ(picture(""), picture("--colour feed"));
  expect_wrong_use("corner.nc --colour time_lost --out a.png", "compares two runs, but there is only one");
  expect_wrong_use("corner.nc --colour following_error --out a.png",
                   "no axis of machine spinner-mvc850 has one");
  expect_wrong_use(runs + "--colour time_lost --reference 4 --out a.png", "--reference 4 is not a run");
  expect_wrong_use("corner.nc --view charts --colour feed --out a.png", "has no effect with --view charts");
  EXPECT_EQ(run("corner.nc --colour blue --out a.png").code, 2);
}

TEST_F(RenderCommand, DrawsRapidsAsItIsAsked) {
  std::ofstream few(folder_ / "few.nc");
  few << "G21 G0 X0 Y20\nX20\nG1 Y0 F3000\nX0\n";
  few.close();
  std::ofstream many(folder_ / "many.nc");
  for (int i = 0; i < 300; ++i) {
    many << "G0 X0 Y" << 0.1 * i << "\nG1 X40 F3000\n";
  }
  many.close();
  const auto picture = [&](const std::string& program, const std::string& options) {
    EXPECT_EQ(run(program + " --size 400x300 --camera top --out rapids.png" + options).code, 0) << options;
    return read_png((folder_ / "rapids.png").string()).rgb;
  };
  EXPECT_EQ(picture("few.nc", ""), picture("few.nc", " --rapids auto"));
  EXPECT_EQ(picture("few.nc", ""), picture("few.nc", " --rapids show"));
  EXPECT_NE(picture("few.nc", ""), picture("few.nc", " --rapids hide"));
  EXPECT_EQ(picture("many.nc", ""), picture("many.nc", " --rapids hide")) << "they would cover the path";
  EXPECT_NE(picture("many.nc", ""), picture("many.nc", " --rapids show"));
  expect_wrong_use("few.nc --view charts --rapids hide --out a.png", "has no effect with --view charts");
  expect_wrong_use("few.nc --lens 2 --rapids hide --out a.png", "has no effect with --lens");
}

TEST_F(RenderCommand, DrawsThePlacesOfTheReport) {
  const auto picture = [&](const std::string& options) {
    const Result result = run("corner.nc --size 416x290 --out place.png" + options);
    EXPECT_EQ(result.code, 0) << options << result.err;
    return read_png((folder_ / "place.png").string()).rgb;
  };
  EXPECT_EQ(picture(" --place 1"), picture(" --place 1"));
  EXPECT_NE(picture(" --place 1"), picture(""));
  const std::string tolerances = " --tolerance 0.01 --tolerance 0.05 --model essid";
  EXPECT_NE(picture(tolerances + " --place 1"), picture(" --place 1")) << "runs are seen through the lens";
  expect_wrong_use("corner.nc --place 99 --out a.png", "--place 99: the run has ");
  expect_wrong_use("corner.nc --place 0 --out a.png", "--place");
  expect_wrong_use("corner.nc --place 1 --lens 2 --out a.png", "--lens has no effect with --place");
  expect_wrong_use("corner.nc --place 1 --view charts --out a.png", "--view has no effect with --place");
}

/// Of two machines the faster one is recommended, and places that are no corners show its run alone.
TEST_F(RenderCommand, DrawsThePlacesOfTheRecommendedRun) {
  std::ofstream(folder_ / "line.nc") << "G21 G1 X100 F6000\n";
  const auto place_on = [&](const std::string& machines) {
    const Result result = run("line.nc --size 416x290 --place 1 --model essid --out place.png" + machines);
    EXPECT_EQ(result.code, 0) << machines << result.err;
    auto pixels = read_png((folder_ / "place.png").string()).rgb;
    constexpr std::size_t above_caption = std::size_t{416} * 265 * 3;  // the caption names the run
    pixels.resize(std::min(pixels.size(), above_caption));
    return pixels;
  };
  const std::string slow = " --machine spinner-mvc850";
  const std::string fast = " --machine huron-kx10";
  EXPECT_EQ(place_on(slow + fast), place_on(fast));
  EXPECT_EQ(place_on(fast + slow), place_on(fast));
  EXPECT_NE(place_on(slow), place_on(fast));
}

TEST_F(RenderCommand, PaperHasItsPixels) {
  ASSERT_EQ(run("corner.nc --size A4 --dpi 100 --out lying.png").code, 0);
  ASSERT_EQ(run("corner.nc --size A4-portrait --dpi 100 --out upright.png").code, 0);
  const auto lying = read_png((folder_ / "lying.png").string());
  const auto upright = read_png((folder_ / "upright.png").string());
  EXPECT_EQ(lying.size.width, 1169);
  EXPECT_EQ(lying.size.height, 827);
  EXPECT_EQ(upright.size.width, lying.size.height);
}

TEST_F(RenderCommand, ScaleMakesTextLargerNotThePicture) {
  for (const std::string view : {"3d", "charts"}) {
    ASSERT_EQ(run("corner.nc --view " + view + " --size 1200x900 --out plain.png").code, 0);
    ASSERT_EQ(run("corner.nc --view " + view + " --size 1200x900 --scale 1.5 --out large.png").code, 0);
    const auto plain = read_png((folder_ / "plain.png").string());
    const auto large = read_png((folder_ / "large.png").string());
    EXPECT_EQ(large.size.width, 1200);
    EXPECT_NE(large.rgb, plain.rgb);
  }
}

TEST_F(RenderCommand, AWindowOfFourTimesThePixelsHasTypeOfTwiceTheSize) {
  ASSERT_EQ(run("corner.nc --view window --size 3840x2160 --out plain.png").code, 0);
  ASSERT_EQ(run("corner.nc --view window --size 3840x2160 --scale 2 --out twice.png").code, 0);
  const auto plain = read_png((folder_ / "plain.png").string());
  EXPECT_EQ(plain.size.width, 3840);
  EXPECT_EQ(plain.rgb, read_png((folder_ / "twice.png").string()).rgb);
}

TEST_F(RenderCommand, SeveralRunsShareAPictureAndAWindow) {
  EXPECT_EQ(run("corner.nc --view sheet --size 1200x900 --tolerance 0.01 --tolerance 0.05 --out a.png").code,
            0);
  EXPECT_EQ(run("corner.nc --view window --tolerance 0.01 --tolerance 0.05 --out b.png").code, 0);
}

TEST_F(RenderCommand, RefusesWhatDoesNotFitTogether) {
  expect_wrong_use("corner.nc --out a.jpg",
                   "--out 'a.jpg' does not state the format; end it in .png, .svg, .pdf, or add --format");
  expect_wrong_use("corner.nc --out picture", "--out 'picture' does not state the format");
  expect_wrong_use("corner.nc --size 800x600 --dpi 300 --out a.png", "--dpi has no effect");
  expect_wrong_use("corner.nc --size A4 --dpi 1000 --out a.png", "smaller --dpi");
  expect_wrong_use("corner.nc --size A4-potrait --out a.png", "did you mean 'A4-portrait'");
  expect_wrong_use("corner.nc --view window --transparent --out a.png", "no transparent background");
  expect_wrong_use("corner.nc --view sheet --size 400x300 --out a.png", "at least 880");
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

TEST_F(RenderCommand, SpeaksFrenchWhereItIsAskedTo) {
  const auto drawn = [&](const std::string& view, const std::string& language) {
    const Result result = run("corner.nc --view " + view + " --size 900x700 --out p.png" + language);
    EXPECT_EQ(result.code, 0) << view << result.err;
    std::ostringstream bytes;
    bytes << std::ifstream(folder_ / "p.png", std::ios::binary).rdbuf();
    return bytes.str();
  };
  for (const std::string view : {"3d", "charts", "window"}) {
    const std::string english = drawn(view, "");
    EXPECT_TRUE(drawn(view, " --language en") == english) << view;
    EXPECT_FALSE(drawn(view, " --language fr") == english) << view;
  }
  expect_wrong_use("corner.nc --language xx --out p.png", "--language: xx not in {en,fr}");
}

TEST_F(RenderCommand, PdfFilesHoldTextsOfEveryLetter) {
  const auto text_of = [&](const std::string& options) {
    EXPECT_EQ(run("corner.nc " + options + " --language fr --out t.pdf").code, 0) << options;
    EXPECT_EQ(std::system(("cd '" + folder_.string() + "' && pdftotext t.pdf t.txt").c_str()), 0);
    std::ostringstream text;
    text << std::ifstream(folder_ / "t.txt", std::ios::binary).rdbuf();
    return text.str();
  };
  const std::string scene = text_of("--colour contour_error");
  EXPECT_THAT(scene, HasSubstr("µm"));
  EXPECT_THAT(scene, HasSubstr("programmée"));
  const std::string sheet = text_of("--view sheet --tolerance 0.01");
  EXPECT_THAT(sheet, HasSubstr("temps de cycle"));
  EXPECT_THAT(sheet, HasSubstr("essid, 0,01 mm"));
  EXPECT_THAT(sheet, HasSubstr("programmée"));
  EXPECT_THAT(sheet, HasSubstr("--language fr"));
  EXPECT_THAT(sheet, testing::Not(HasSubstr("cycle time")));
}

/// The command at the foot of a sheet is there to be run again: on two lines rather than with a piece
/// omitted.
TEST_F(RenderCommand, ASheetHoldsItsWholeCommandHoweverLong) {
  const std::string name = std::string(100, 'p') + "art_of_a_long_name.nc";
  std::filesystem::copy(folder_ / "corner.nc", folder_ / name);
  const std::string command = name + " --view sheet --title " + std::string(260, 'T') + " --out t.pdf";
  ASSERT_EQ(run(command).code, 0);
  ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && pdftotext t.pdf t.txt").c_str()), 0);
  std::ifstream printed(folder_ / "t.txt", std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(printed), {}};
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  EXPECT_THAT(text, HasSubstr(std::string(100, 'p') + "art_of_a_long_name.nc--viewsheet"));
  EXPECT_THAT(text, HasSubstr(std::string(260, 'T') + "--outt.pdf"));
}

TEST_F(RenderCommand, WritesToStandardOutput) {
  EXPECT_EQ(run("corner.nc --size 200x100 --out - > piped.png").code, 0);
  EXPECT_EQ(read_png((folder_ / "piped.png").string()).size.width, 200);
}

TEST_F(RenderCommand, DrawsTheRestOfAProgramWithErrors) {
  const Result result = run("wrong.nc --size 200x100 --out rest.png");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, HasSubstr("wrong.nc:2:"));
  EXPECT_EQ(read_png((folder_ / "rest.png").string()).size.height, 100);
}

TEST_F(RenderCommand, RefusesASizeThatIsNone) {
  for (const std::string size : {"800", "800x", "x600", "800x600x3", "wide", "8e2x600", "-800x600"}) {
    expect_wrong_use("corner.nc --size=" + size + " --out a.png", "--size '" + size + "'");
  }
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

TEST_F(RenderCommand, RefusesASizeOutOfBoundsWithTheBounds) {
  expect_wrong_use("corner.nc --size 20x600 --out a.png", "64 to 8192");
  expect_wrong_use("corner.nc --size 800x90000 --out a.png", "90000");
}

TEST_F(RenderCommand, NamesAPlaceItCannotWriteTo) {
  expect_wrong_use("corner.nc --out nowhere/a.png", "cannot write 'nowhere/a.png'");
  expect_wrong_use("corner.nc --format png --out .", "cannot write '.'");
}

TEST_F(RenderCommand, NamesWhatItDoesNotKnow) {
  expect_wrong_use("corner.nc --camera below --out a.png", "below");
  expect_wrong_use("corner.nc --view 4d --out a.png", "4d");
  expect_wrong_use("corner.nc", "--out");
  expect_wrong_use("missing.nc --out a.png", "missing.nc");
}

/// The command at the foot of a sheet, run as it is printed, makes the sheet again.
TEST_F(RenderCommand, TheCommandOnASheetMakesTheSheet) {
  const auto bytes = [&](const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return text.str();
  };
  for (const std::string options :
       {"--view sheet --tolerance 0.01 --tolerance 0.05 --theme dark --title 'A b' --camera top --out s.pdf",
        "--view sheet --size A3 --dpi 150 --scale 1.25 --display-units inch --format pdf --transparent --out "
        "s.pdf"}) {
    ASSERT_EQ(run("corner.nc " + options).code, 0) << options;
    const std::string sheet = bytes("s.pdf");
    ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && pdftotext -raw s.pdf s.txt").c_str()), 0);
    const std::string text = bytes("s.txt");
    const std::size_t begin = text.find("feedscope render ");
    ASSERT_NE(begin, std::string::npos) << text;
    const std::string arguments = text.substr(begin + 17, text.find('\n', begin) - begin - 17);
    fs::remove(folder_ / "s.pdf");
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 0) << arguments << ": " << result.err;
    EXPECT_EQ(bytes("s.pdf"), sheet) << arguments;
  }
}

}  // namespace
