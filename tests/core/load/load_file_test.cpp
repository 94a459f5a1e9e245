#include "core/load/load_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <random>

#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string operation =
    "[[operation]]\ntool = 1\ndiameter_mm = 12\nteeth = 2\nhelix_deg = 30\nae_mm = 3\nap_mm = 5\n"
    "milling = \"down\"\nmaterial = \"aluminium-7075-t6\"\n";
const std::string material =
    "[[material]]\nid = \"mine\"\nsource = \"measured\"\nlaw = \"kienzle\"\nkc11_n_mm2 = 1800\nmc = 0.2\n"
    "radial_share = 0.4\naxial_share = 0.1\n";

std::string with(const std::string& rest) {
  return "feedscope_load = 1\n" + rest;
}

/// `text` with `from` replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(LoadFile, IsReadInUnitsOfTheCore) {
  const LoadSetup setup = parse_load(
      with(operation + "lines = \"10-25, 40\"\nspindle_1_min = 6000\nmin_chip_um = 4\nmax_chip_um = 80\n"
                       "max_force_n = 500\nmax_torque_nm = 2\nmax_power_kw = 1.5\n"),
      "load.toml");
  ASSERT_EQ(setup.operations.size(), 1U);
  const Engagement& read = setup.operations.front();
  EXPECT_EQ(read.tool, "1");
  EXPECT_THAT(read.lines, testing::ElementsAre(ProgramLines{10, 25}, ProgramLines{40, 40}));
  EXPECT_EQ(read.diameter, 12);
  EXPECT_EQ(read.teeth, 2);
  EXPECT_DOUBLE_EQ(read.helix, units::pi / 6);
  EXPECT_EQ(read.radial_depth, 3);
  EXPECT_EQ(read.axial_depth, 5);
  EXPECT_EQ(read.milling, Milling::down);
  EXPECT_EQ(read.spindle_speed, 100);
  EXPECT_EQ(read.least_chip, 0.004);
  EXPECT_EQ(read.max_chip, 0.08);
  EXPECT_EQ(read.max_force, 500);
  EXPECT_EQ(read.max_torque, 2000);
  EXPECT_EQ(read.max_power, 1.5e6);
}

TEST(LoadFile, NamesToolsAsProgramsDo) {
  EXPECT_EQ(parse_load(with(replaced(operation, "tool = 1", "tool = \"mill_10\"")), "x").operations[0].tool,
            "MILL_10");
  EXPECT_EQ(parse_load(with(replaced(operation, "tool = 1", "tool = \"007\"")), "x").operations[0].tool, "7");
  EXPECT_EQ(parse_load(with(replaced(operation, "tool = 1", "")), "x").operations[0].tool, "");
}

TEST(LoadFile, ReadsMaterialsOfOnesOwn) {
  const LoadSetup setup =
      parse_load(with(replaced(operation, "aluminium-7075-t6", "mine") + material), "load.toml");
  ASSERT_EQ(setup.materials.size(), 1U);
  EXPECT_EQ(setup.materials[0].specific_force, 1800);
  EXPECT_EQ(setup.materials[0].exponent, 0.2);
  EXPECT_EQ(setup.materials[0].share[1], 0.4);
  EXPECT_EQ(setup.materials[0].title, "mine");
}

TEST(LoadFile, IsWrittenAsItIsRead) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> typed(1, 9999);
  const auto share = [&](std::mt19937& from) { return typed(from) / 1e4; };  // as people type numbers
  for (int i = 0; i < 200; ++i) {
    LoadSetup setup;
    Material own;
    own.id = "mine \"two\"\\ \n";
    own.title = "title";
    own.source = "measured";
    own.cutting = {1 + 1000 * share(random), 100 * share(random), 0};
    own.edge = {share(random), 0, 30 * share(random)};
    Material other = own;
    other.id = "other";
    other.law = CuttingLaw::kienzle;
    other.specific_force = 1 + 2000 * share(random);
    other.exponent = share(random) / 2;
    other.share = {1, share(random), share(random)};
    other.cutting = other.edge = {};
    setup.materials = {own, other};
    for (int k = 0; k < 3; ++k) {
      Engagement one;
      one.tool = fmt::format("{}", k + 1);
      one.diameter = 0.1 + 20 * share(random);
      one.teeth = 1 + k;
      one.helix = units::from_deg(60 * share(random));
      one.radial_depth = one.diameter * std::max(0.01, share(random));
      one.axial_depth = 0.01 + share(random);
      one.milling = k % 2 == 0 ? Milling::up : Milling::down;
      one.material = k == 0 ? own.id : other.id;
      if (k > 0) {
        one.lines = {{1, 5}, {7, 7}};
        one.spindle_speed = units::from_rev_min(30000 * share(random));
        one.least_chip = units::from_um(10 * share(random));
        one.max_chip = 0.1;
        one.max_force = 1 + share(random);
        one.max_power = units::from_kw(share(random));
        one.max_torque = units::from_n_m(share(random));
      }
      setup.operations.push_back(one);
    }
    const std::string text = load_file_text(setup);
    EXPECT_EQ(parse_load(text, "again.toml"), setup) << text;
  }
}

struct BadFile {
  std::string text;
  std::string message;
};

TEST(LoadFile, SaysWhatIsWrongAndWhere) {
  const std::vector<BadFile> cases{
      {"", "'feedscope_load' is missing"},
      {replaced(with(operation), "feedscope_load = 1", "feedscope_load = 2"), "version 2 are not known"},
      {with(""), "no operation"},
      {with("operation = 5\n"), "begin each with [[operation]]"},
      {with("operations = 5\n"), "did you mean 'operation'?"},
      {with("[[operation"), "not valid TOML"},
      {with(replaced(operation, "ae_mm = 3", "ae_mm = 13")), "ae_mm 13 is larger than diameter_mm 12"},
      {with(replaced(operation, "ae_mm = 3", "ae_mm = 0")), "ae_mm"},
      {with(replaced(operation, "ap_mm = 5", "ap_mm = -5")), "ap_mm"},
      {with(replaced(operation, "ap_mm = 5", "ap_mm = inf")), "ap_mm"},
      {with(replaced(operation, "ap_mm = 5", "ap_mm = nan")), "ap_mm"},
      {with(replaced(operation, "ap_mm = 5\n", "")), "'ap_mm' is missing in [[operation]] number 1"},
      {with(replaced(operation, "ap_mm = 5", "ap_mm = \"5\"")),
       "ap_mm in [[operation]] number 1 must be a number"},
      {with(replaced(operation, "teeth = 2", "teeth = 0")), "teeth"},
      {with(replaced(operation, "teeth = 2", "teeth = 2.5")), "teeth"},
      {with(replaced(operation, "helix_deg = 30", "helix_deg = 90")), "helix_deg"},
      {with(replaced(operation, "\"down\"", "\"climb\"")), "milling 'climb' is not known"},
      {with(replaced(operation, "7075-t6", "7075")), "did you mean 'aluminium-7075-t6'?"},
      {with(replaced(operation, "tool = 1", "tool = 1.5")), "'tool' must be its number"},
      {with(replaced(operation, "tool = 1", "tool = \"\"")), "'tool' must be its number"},
      {with(replaced(operation, "tool = 1", "tol = 1")), "did you mean 'tool'?"},
      {with(operation + "lines = \"25-10\"\n"), "lines 25-10 is no range"},
      {with(operation + "lines = \"a\"\n"), "must be ranges"},
      {with(operation + "lines = \"1-2 3;\"\n"), "must be ranges"},
      {with(operation + "lines = \"1-\"\n"), "must be ranges"},
      {with(operation + "lines = \"99999999999\"\n"), "must be ranges"},
      {with(operation + "lines = 4\n"), "must be ranges"},
      {with(operation + "max_force_n = 0\n"), "max_force_n"},
      {with(operation + operation), "operations 1 (tool 1) and 2 (tool 1) apply to the same motions"},
      {with(operation + "lines = \"1-9\"\n" + replaced(operation, "tool = 1\n", "lines = \"9-12\"\n")),
       "apply to the same motions"},
      {with(operation + material + material), "material 'mine' is given twice"},
      {with(operation + replaced(material, "source = \"measured\"\n", "")), "'source' is missing"},
      {with(operation + replaced(material, "kienzle", "hooke")), "law 'hooke' is not known"},
      {with(operation + replaced(material, "kc11_n_mm2 = 1800", "kc11_n_mm2 = 0")), "must be above 0"},
      {with(operation + replaced(material, "mc = 0.2", "mc = 1")), "mc"},
      {with(operation + material + "ktc_n_mm2 = 5\n"), "unknown key 'ktc_n_mm2'"},
  };
  for (const BadFile& bad : cases) {
    EXPECT_THAT([&] { parse_load(bad.text, "load.toml"); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("load.toml:"), HasSubstr(bad.message))))
        << bad.text;
  }
}

TEST(LoadFile, ThatCannotBeReadIsNamed) {
  EXPECT_THAT([] { read_load_file("/nowhere/load.toml"); },
              ThrowsMessage<InputError>(HasSubstr("cannot read load file '/nowhere/load.toml'")));
}

/// One with lines before one without, each tool its own.
TEST(LoadFile, LetsOperationsOfLinesStandOverOthers) {
  const LoadSetup setup =
      parse_load(with(operation + replaced(operation, "tool = 1", "tool = 1\nlines = \"5-9\"") +
                      replaced(operation, "tool = 1\n", "")),
                 "load.toml");
  EXPECT_EQ(setup.operations.size(), 3U);
}

}  // namespace
}  // namespace feedscope
