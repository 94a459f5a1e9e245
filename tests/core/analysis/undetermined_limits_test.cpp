#include "core/analysis/notes/undetermined_limits.h"

#include <gmock/gmock.h>

#include "core/machine/undetermined.h"

namespace feedscope {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The mill with numbers that recordings do not determine, read from its file.
Setup mill_without(const std::vector<std::string>& keys) {
  SetupRequest request;
  request.machine = "linuxcnc-mill";
  request.assignments = {"max_linear_velocity_m_min=60"};
  Setup setup = make_setup(request);
  setup.machine.settings.set("max_linear_velocity_m_min", 60.0);
  for (const std::string& key : keys) {
    setup.machine.provenance[key] = {std::string(undetermined_by) + "drill.csv: kept from before: a guess",
                                     true};
  }
  setup.machine = parse_machine(write_machine(setup.machine), "mill.toml", machine_file_settings());
  return setup;
}

std::vector<UndeterminedLimit> limits_on(const std::string& program, const Setup& setup) {
  const auto source = std::make_shared<const SourceText>(SourceText("p.ngc", program));
  return undetermined_limits(simulate_run(load_program(source), setup));
}

/// From rest to rest over 100 mm at 6 m/min with 0.75 m/s2: half of the acceleration to 100 mm/s takes 2/15
/// s, and as long to slow down, which counts for the stop; between them 13/15 s at the limit of the velocity.
TEST(UndeterminedLimits, AreNamedWithTheTimeThatTheyLimit) {
  const std::string rapid = "G21 G90 G61\nG0 X100\nM30\n";
  const auto velocity = limits_on(rapid, mill_without({"X.velocity", "Y.velocity", "Y.acceleration"}));
  ASSERT_EQ(velocity.size(), 1U) << "Y stands";
  EXPECT_EQ(velocity[0].key, "X.velocity");
  EXPECT_NEAR(velocity[0].time, 13.0 / 15, 5e-3);
  EXPECT_NEAR(velocity[0].share, 13.0 / 17, 5e-3);
  const auto both = limits_on(rapid, mill_without({"X.velocity", "X.acceleration"}));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].key, "X.acceleration");
  EXPECT_NEAR(both[1].time, 2.0 / 15, 5e-3);
  EXPECT_THAT(describe(both[0]).english(), HasSubstr("X.velocity limits 0.86"));
  EXPECT_THAT(describe(both[0]).english(), HasSubstr("do not determine it"));
}

TEST(UndeterminedLimits, AreNoneWhereTheyLimitNothingOrAnotherValueIsSet) {
  const std::string slow = "G21 G90 G61\nG1 X100 F600\nM30\n";
  EXPECT_THAT(limits_on(slow, mill_without({"X.velocity", "max_linear_velocity_m_min"})), IsEmpty());
  const std::string rapid = "G21 G90 G61\nG0 X100\nM30\n";
  auto changed = mill_without({"X.velocity", "X.acceleration"});
  set_axis_limit(changed.machine, 'X', "velocity", 5);
  set_axis_limit(changed.machine, 'X', "acceleration", 1);
  EXPECT_THAT(limits_on(rapid, changed), IsEmpty());
  EXPECT_THAT(limits_on(rapid, mill_without({})), IsEmpty());
}

/// A setting that is set for the run is not that of the machine any more.
TEST(UndeterminedLimits, OfSettingsAreThoseOfTheMachine) {
  const std::string rapid = "G21 G90 G61\nG0 X100\nM30\n";
  auto setup = mill_without({"max_linear_velocity_m_min"});
  setup.machine.settings.set("max_linear_velocity_m_min", 3.0);
  setup.settings.set("max_linear_velocity_m_min", 3.0);
  const auto found = limits_on(rapid, setup);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "max_linear_velocity_m_min");
  setup.settings.set("max_linear_velocity_m_min", 2.0);
  EXPECT_THAT(limits_on(rapid, setup), IsEmpty());
}

}  // namespace
}  // namespace feedscope
