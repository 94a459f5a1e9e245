#include "ui/identification/identification_outcome.h"

#include <gtest/gtest.h>

#include "core/identification/fit_parameter.h"

namespace feedscope::ui {
namespace {

class IdentificationOutcomeTest : public testing::Test {
 protected:
  IdentificationOutcomeTest() {
    request.program = load_program(std::make_shared<const SourceText>("part.nc", "G21 G90\nG1 X30 F6000\n"));
    request.starts = {{begun_with({}), {"X.acceleration"}}};
    outcome.program = program_mark(request.program);
    Identification found;
    found.setup = request.starts[0].setup;
    IdentifiedParameter one;
    one.parameter = fit_parameters_of(found.setup, {"X.acceleration"})[0];
    one.start = fit_value(found.setup, one.parameter);
    one.value = 1.3;
    set_fit_value(found.setup, one.parameter, one.value);
    found.setup.machine.provenance["X.acceleration"] = {"identified from scope.csv", false};
    found.parameters = {one};
    outcome.models = {found};
  }
  static feedscope::Setup begun_with(const std::vector<std::string>& assignments) {
    SetupRequest asked;
    asked.machine = "linuxcnc-mill";
    asked.assignments = assignments;
    return make_setup(asked);
  }

  IdentificationRequest request;
  IdentificationOutcome outcome;
};

TEST_F(IdentificationOutcomeTest, IsOfWhatWasAskedForWhateverWasFound) {
  EXPECT_TRUE(is_of(outcome, request));
  request.starts[0].setup.machine.provenance["Y.acceleration"] = {"set by hand", false};
  EXPECT_TRUE(is_of(outcome, request)) << "the number is the same";
}

/// What is found depends on all that the search holds.
TEST_F(IdentificationOutcomeTest, IsNotOfAMachineWithOtherLimitsOrSettings) {
  for (const char* other : {"X.acceleration=0.5", "Y.acceleration=0.5", "Z.velocity=1.7",
                            "blend_tolerance_mm=0.05", "planner=master"}) {
    request.starts[0].setup = begun_with({other});
    EXPECT_FALSE(is_of(outcome, request)) << other;
  }
}

}  // namespace
}  // namespace feedscope::ui
