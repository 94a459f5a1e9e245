#include "tests/samples/samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/control_dialect.h"
#include "tests/samples/essid.h"
#include "tests/samples/nc_writer.h"
#include "tests/support/folders.h"

namespace feedscope::samples {
namespace {

const std::filesystem::path folder = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs";

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Samples, ShippedFilesAreWhatTheGeneratorWrites) {
  for (const Sample& sample : all_samples()) {
    // Not EXPECT_EQ: a difference would print megabytes.
    EXPECT_TRUE(read(folder / sample.file_name) == sample.text)
        << sample.file_name << " differs: run build/dev/tests/samples/generate_samples resources/programs";
  }
}

/// Programs that show a dialect's words, written by hand; the reader's tests read them.
const std::set<std::string> by_hand{
    "fanuc_bores.nc",      "fanuc_flange.nc",     "linuxcnc_superellipse.ngc", "heidenhain_plate.h",
    "heidenhain_spiral.i", "sinumerik_plate.mpf", "sinumerik_wave.mpf",        "lesson_rough_finish.h",
    "lesson_slot.nc",      "lesson_directions.nc"};

TEST(Samples, NoOtherProgramIsShipped) {
  std::set<std::string> known = by_hand;
  for (const Sample& sample : all_samples()) {
    known.insert(sample.file_name);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".nc") {
      EXPECT_TRUE(known.contains(entry.path().filename())) << entry.path();
    }
  }
}

TEST(Samples, EachIsExplainedInTheFoldersReadme) {
  const std::string readme = read(folder / "README.md");
  for (const Sample& sample : all_samples()) {
    EXPECT_THAT(readme, testing::HasSubstr("`" + sample.file_name + "`"));
  }
  for (const std::string& name : by_hand) {
    EXPECT_THAT(readme, testing::HasSubstr("`" + name + "`"));
  }
}

/// A newcomer reads results, not warnings; events without a time are a row of the figures.
TEST(Samples, AFirstSimulationHasAtMostTwoRemarks) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".md") {
      continue;
    }
    const auto source = std::make_shared<const SourceText>(SourceText::from_file(entry.path()));
    const auto dialect = load_program(source).program->dialect;
    const auto setup = make_setup({.machine = default_machine_of(dialect), .dialect = dialect});
    const auto run = simulate_run(load_program(source, nullptr, reading_on({}, setup.machine)), setup);
    EXPECT_LE(
        std::ranges::count_if(
            remarks(run), [](const Remark& remark) { return remark.about != Remark::About::not_counted; }),
        2)
        << entry.path();
  }
}

TEST(Samples, SplineIsCutWhereThePublishedTessellationIs) {
  const std::vector<double> expected{0,       .081838, .165539, .266221, .432464, .614478,
                                     .717193, .801479, .883121, .970499, 1};
  EXPECT_THAT(spline_parameters(0.5), testing::Pointwise(testing::DoubleNear(1e-6), expected));
}

TEST(Samples, FreeFormSurfaceHasAtLeast50000BlocksInLessThanTwoAndAHalfMegabytes) {
  const std::string text = freeform_finish().text;
  EXPECT_GE(std::count(text.begin(), text.end(), '\n'), 50'000);
  EXPECT_LT(text.size(), 2'500'000u);
}

TEST(NcWriter, LeavesOutWhatDidNotChange) {
  NcWriter nc(3);
  nc.line({1, 0, 0}, 600);
  nc.line({1, -0.00049, 2.5});
  nc.line({1, 0, 2.5});
  nc.arc(false, {1, 4, 2.5}, {1, 2});
  nc.line({0, 4, 2.5});
  EXPECT_EQ(nc.text(), "G1 X1 F600\nZ2.5\nG3 Y4 I0 J2\nG1 X0\n");
}

}  // namespace
}  // namespace feedscope::samples
