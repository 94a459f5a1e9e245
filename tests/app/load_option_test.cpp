#include <nlohmann/json.hpp>

#include "tests/app/command_line.h"

namespace {

using feedscope::test::contents;
using feedscope::test::Result;
using nlohmann::json;
using testing::HasSubstr;

class LoadOption : public feedscope::test::CommandLine {
 protected:
  LoadOption() {
    write("load.toml", load);
    write("milled.nc", "G21\nT1 M6\nS8000 M3\nG1 X20 F3000\nY20\nM30\n");
  }

  const std::string load =
      "feedscope_load = 1\n[[operation]]\ntool = 1\ndiameter_mm = 12\nteeth = 2\nhelix_deg = 30\nae_mm = 3\n"
      "ap_mm = 5\nmilling = \"down\"\nmaterial = \"aluminium-7075-t6\"\nmin_chip_um = 20\n";
};

TEST_F(LoadOption, AddsTheLoadToEveryResult) {
  const Result result = run("simulate milled.nc --load load.toml --json run.json --csv run.csv");
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Cutting load over"));
  EXPECT_THAT(result.out, HasSubstr("engagement as given"));
  EXPECT_THAT(result.out, HasSubstr("chip below its least thickness (rubbing)"));
  const json written = json::parse(contents(folder_ / "run.json"))["load"];
  // 3000 mm/min over 8000/min and two teeth
  EXPECT_NEAR(written["programmed"]["feed_per_tooth_mm"]["mean"].get<double>(), 0.1875, 1e-9);
  EXPECT_LT(written["predicted"]["cutting_force_peak_n"]["mean"].get<double>(),
            written["programmed"]["cutting_force_peak_n"]["mean"].get<double>());
  EXPECT_EQ(written["limits"][0]["bound"], "min_chip_um");
  const std::string csv = contents(folder_ / "run.csv");
  EXPECT_THAT(csv.substr(0, csv.find('\n')), testing::EndsWith("power_programmed_kw"));
}

TEST_F(LoadOption, ChangesNothingElse) {
  json with = json::parse(run("simulate milled.nc --load load.toml --json -").out);
  json without = json::parse(run("simulate milled.nc --json -").out);
  EXPECT_TRUE(without["load"].is_null());
  for (const char* key : {"load", "elapsed"}) {
    with.erase(key);
    without.erase(key);
  }
  EXPECT_EQ(with, without);
}

TEST_F(LoadOption, SaysWhereNoLoadIsComputed) {
  write("stands.nc", "G21\nT1 M6\nG1 X20 F3000\nS8000 M3\nY20\nM5\nX0\nM30\n");
  EXPECT_THAT(run("simulate stands.nc --load load.toml").out,
              HasSubstr("spindle stands or has no known speed"));
}

TEST_F(LoadOption, NamesWhatIsWrong) {
  expect_wrong_use("simulate milled.nc --load none.toml", "cannot read load file 'none.toml'");
  expect_wrong_use("simulate corner.nc --load load.toml",
                   "operation for tool 1, but the program changes to no tool");
  expect_wrong_use("simulate milled.nc --load load.toml --csv load.toml", "it is the load file");
  write("wide.toml", std::string(load).replace(load.find("ae_mm = 3"), 9, "ae_mm = 13"));
  expect_wrong_use("simulate milled.nc --load wide.toml", "ae_mm 13 is larger than diameter_mm 12");
}

}  // namespace
