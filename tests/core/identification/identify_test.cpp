#include "core/identification/identify.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;

/// Isolated moves of X and Y, corners and arcs, with stops between.
constexpr const char* program_text =
    "G21 G90 G17\nG1 X60 F12000\nG4 P0.2\nX0\nG4 P0.2\nY50\nG4 P0.2\nY0\nG4 P0.2\nX20 F6000\nY20\nG4 "
    "P0.2\nX0\nY0\n"
    "G4 P0.2\nX30 Y15\nX60 Y0\nG4 P0.2\nX30 Y30\nX0 Y0\nG4 P0.2\nG2 X40 Y0 I20 J0 F9000\nG2 X0 Y0 I-20 "
    "J0\nG4 P0.2\n"
    "X4 Y5\nX8 Y0\nX12 Y5\nX16 Y0\nX20 Y5\nX24 Y0\nM30\n";

Setup setup_of(const std::string& machine, const std::vector<std::string>& settings) {
  SetupRequest request;
  request.machine = machine;
  request.assignments = settings;
  return make_setup(request);
}

LoadedProgram program() {
  return load_program(std::make_shared<const SourceText>(SourceText("p.ngc", program_text)));
}

/// What a control would have recorded: rounded to 1 um, noisy, shifted.
Trace trace_of(const Setup& setup, double period, double noise, unsigned seed) {
  const Run run = simulate_run(program(), setup);
  const MotionRecord record = record_of(*run.trajectory, period);
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0, noise);
  Trace trace;
  trace.name = "t.csv";
  trace.period = period;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    trace.time.push_back(record.time[i] + 1e-9 * static_cast<double>(i));
    for (int axis = 0; axis < 3; ++axis) {
      trace.place[static_cast<std::size_t>(axis)].push_back(
          std::round(1e3 * (record.place[i][axis] + error(random))) / 1e3 + 0.25 * axis);
    }
  }
  return trace;
}

const IdentifiedParameter& of(const Identification& found, const std::string& key) {
  for (const IdentifiedParameter& one : found.parameters) {
    if (one.parameter.key == key) {
      return one;
    }
  }
  throw InputError("no " + key);
}

void expect_truth(const Identification& found, const std::string& key, double truth) {
  const IdentifiedParameter& one = of(found, key);
  EXPECT_TRUE(one.told) << key << ": " << one.reason;
  EXPECT_LE(std::abs(one.value - truth), std::max(0.02 * truth, one.uncertainty))
      << key << " = " << one.value << " +- " << one.uncertainty;
}

TEST(Identify, FindsLimitsOfAJerkLimitedControlFromANoisyTrace) {
  const auto truth = setup_of("spinner-mvc850", {"X.acceleration=1.7", "Y.acceleration=1.2", "X.jerk=24",
                                                 "Y.jerk=30", "program_tolerance=off"});
  const auto start = setup_of("spinner-mvc850", {"program_tolerance=off"});
  const FitCase one(trace_of(truth, 4e-3, 2e-4, 3), program(), start);
  const Identification found =
      identify({one}, start,
               fit_parameters_of(start, {"X.acceleration", "Y.acceleration", "X.jerk", "Y.jerk", "Z.jerk"}));
  EXPECT_TRUE(found.explains);
  expect_truth(found, "X.acceleration", 1.7);
  expect_truth(found, "Y.acceleration", 1.2);
  expect_truth(found, "X.jerk", 24);
  expect_truth(found, "Y.jerk", 30);
  EXPECT_FALSE(of(found, "Z.jerk").told);
  EXPECT_THAT(of(found, "Z.jerk").reason, HasSubstr("changes nothing"));
  EXPECT_EQ(of(found, "Z.jerk").value, of(found, "Z.jerk").start);
  EXPECT_THAT(found.setup.machine.provenance.at("X.jerk").source, HasSubstr("identified from t.csv"));
}

TEST(Identify, SaysOfALimitThatIsNeverReachedWhatItIsAtLeast) {
  const auto truth = setup_of("linuxcnc-mill", {"X.velocity=15", "max_linear_velocity_m_min=60"});
  const FitCase one(trace_of(truth, 1e-3, 1e-4, 5), program(), truth);
  const Identification found =
      identify({one}, truth, fit_parameters_of(truth, {"X.velocity", "X.acceleration"}));
  const IdentifiedParameter& velocity = of(found, "X.velocity");
  EXPECT_FALSE(velocity.told);
  ASSERT_TRUE(velocity.at_least.has_value());
  EXPECT_LE(*velocity.at_least, 12.1);
  EXPECT_GT(*velocity.at_least, 8);
  EXPECT_EQ(axis_limit(found.setup.machine, 'X', "velocity"), 15) << "what explains the trace as well stays";
  EXPECT_EQ(found.setup.machine.provenance.at("X.velocity").source,
            truth.machine.provenance.at("X.velocity").source);

  const auto slow = setup_of("linuxcnc-mill", {"X.velocity=5", "max_linear_velocity_m_min=60"});
  const Identification risen =
      identify({one}, slow, fit_parameters_of(slow, {"X.velocity", "X.acceleration"}));
  const IdentifiedParameter& reached = of(risen, "X.velocity");
  ASSERT_TRUE(reached.at_least.has_value());
  EXPECT_EQ(reached.value, *reached.at_least) << "what is too slow becomes what the trace shows at least";
  EXPECT_NEAR(axis_limit(risen.setup.machine, 'X', "velocity"), *reached.at_least, 1e-6);
  expect_truth(found, "X.acceleration", 0.75);
}

TEST(Identify, ReportsAModelThatDoesNotExplainATrace) {
  const auto truth = setup_of("linuxcnc-mill", {});
  const auto start = setup_of("dmg-mori-evo40", {});
  const FitCase one(trace_of(truth, 1e-3, 1e-4, 6), program(), start);
  const Identification found = identify({one}, start, fit_parameters_of(start, {"X.jerk"}));
  EXPECT_FALSE(found.explains);
  EXPECT_FALSE(found.parameters[0].told);
  EXPECT_THAT(found.parameters[0].reason, HasSubstr("does not explain"));
}

TEST(Identify, CanBeCancelled) {
  const auto setup = setup_of("linuxcnc-mill", {});
  const FitCase one(trace_of(setup, 1e-3, 1e-4, 6), program(), setup);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(identify({one}, setup, fit_parameters_of(setup, {"X.acceleration"}), {}, &progress),
               Cancelled);
}

TEST(FitParameters, AreNumbersOfMachineAndModelByKey) {
  const auto setup = setup_of("linuxcnc-mill", {});
  EXPECT_EQ(fit_parameters_of(setup, {"velocity"}).size(), 3U);
  EXPECT_EQ(fit_parameters_of(setup, {"blend_tolerance_mm"}).front().unit, "mm");
  for (const FitParameter& parameter : usual_fit_parameters(setup)) {
    EXPECT_EQ(parameter.key.find("period"), std::string::npos) << parameter.key;
  }
  try {
    fit_parameters_of(setup, {"X.acceleratoin"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'X.acceleration'?"));
  }
}

}  // namespace
}  // namespace feedscope
