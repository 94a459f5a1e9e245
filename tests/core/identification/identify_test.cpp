#include "core/identification/identify.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <set>

#include "core/analysis/time/line_times.h"
#include "core/base/error.h"
#include "core/identification/identification_program.h"
#include "core/identification/section_case.h"
#include "core/identification/trace_case.h"
#include "core/machine/undetermined.h"
#include "tests/support/folders.h"
#include "tests/support/random_cases.h"

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
std::shared_ptr<const Trace> trace_of(const Setup& setup, double period, double noise, unsigned seed,
                                      const LoadedProgram& of = program()) {
  const Run run = simulate_run(of, setup);
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
  return std::make_shared<const Trace>(std::move(trace));
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
  const IdentifiedParameter one = of(found, key);
  EXPECT_TRUE(one.told) << key << ": " << one.reason;
  EXPECT_LE(std::abs(one.value - truth), std::max(0.02 * truth, one.uncertainty))
      << key << " = " << one.value << " +- " << one.uncertainty;
}

TEST(Identify, FindsLimitsOfAJerkLimitedControlFromANoisyTrace) {
  const auto truth = setup_of("spinner-mvc850", {"X.acceleration=1.7", "Y.acceleration=1.2", "X.jerk=24",
                                                 "Y.jerk=30", "program_tolerance=off"});
  const auto start = setup_of("spinner-mvc850", {"program_tolerance=off"});
  const auto one = std::make_shared<const TraceCase>(trace_of(truth, 4e-3, 2e-4, 3), program(), start);
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
  const auto one = std::make_shared<const TraceCase>(trace_of(truth, 1e-3, 1e-4, 5), program(), truth);
  const Identification found =
      identify({one}, truth, fit_parameters_of(truth, {"X.velocity", "X.acceleration"}));
  const IdentifiedParameter velocity = of(found, "X.velocity");
  EXPECT_FALSE(velocity.told);
  ASSERT_TRUE(velocity.at_least.has_value());
  EXPECT_LE(*velocity.at_least, 12.1);
  EXPECT_GT(*velocity.at_least, 8);
  EXPECT_EQ(axis_limit(found.setup.machine, 'X', "velocity"), 15) << "what explains the trace as well stays";
  const Provenance kept = found.setup.machine.provenance.at("X.velocity");
  EXPECT_TRUE(is_undetermined(kept));
  EXPECT_THAT(kept.source, HasSubstr("not determined by t.csv: at least "));
  EXPECT_THAT(kept.source, HasSubstr("m/min, kept from before: set by hand"));
  EXPECT_EQ(parse_machine(write_machine(found.setup.machine), "m.toml", machine_file_settings()).provenance,
            found.setup.machine.provenance);
  const Identification again =
      identify({one}, found.setup, fit_parameters_of(found.setup, {"X.velocity", "X.acceleration"}));
  EXPECT_EQ(again.setup.machine.provenance.at("X.velocity"), kept) << "its origin is not told twice";

  const auto slow = setup_of("linuxcnc-mill", {"X.velocity=5", "max_linear_velocity_m_min=60"});
  const Identification risen =
      identify({one}, slow, fit_parameters_of(slow, {"X.velocity", "X.acceleration"}));
  const IdentifiedParameter reached = of(risen, "X.velocity");
  ASSERT_TRUE(reached.at_least.has_value());
  EXPECT_GE(reached.value, *reached.at_least) << "what is too slow becomes what explains the trace";
  EXPECT_NEAR(axis_limit(risen.setup.machine, 'X', "velocity"), reached.value, 1e-6);
  EXPECT_THAT(risen.setup.machine.provenance.at("X.velocity").source,
              HasSubstr("not determined by t.csv: at least "));
  EXPECT_TRUE(is_undetermined(risen.setup.machine.provenance.at("X.velocity")));
  EXPECT_FALSE(is_undetermined(risen.setup.machine.provenance.at("X.acceleration")));
  EXPECT_NEAR(risen.agreements[0].time_error(), found.agreements[0].time_error(), 1e-4);
  expect_truth(found, "X.acceleration", 0.75);
}

/// Accelerations and junction deviation of grbl stand for each other at every corner, and a velocity hides
/// behind them: one after the other, they end in hollows whose residual is no noise.
TEST(Identify, FindsNumbersThatOnlyTogetherLeaveAWrongExplanation) {
  const LoadedProgram bore =
      load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs/tapie_bore.nc");
  const auto start = setup_of("grbl-router", {});
  const std::map<std::string, double> truth{{"X.velocity", 16.426},
                                            {"X.acceleration", 4.457},
                                            {"Y.velocity", 18.869},
                                            {"Y.acceleration", 3.183},
                                            {"Z.velocity", 25.888},
                                            {"Z.acceleration", 1.66},
                                            {"junction_deviation_mm", 0.0489},
                                            {"arc_tolerance_mm", 0.002}};
  std::vector<std::string> settings;
  for (const auto& [key, value] : truth) {
    settings.push_back(fmt::format("{}={}", key, value));
  }
  const auto one = std::make_shared<const TraceCase>(
      trace_of(setup_of("grbl-router", settings), 4e-3, 0, 1, bore), bore, start);
  const Identification found = identify({one}, start, usual_fit_parameters(start));
  EXPECT_TRUE(found.explains);
  for (const auto& [key, value] : truth) {
    if (of(found, key).told) {
      expect_truth(found, key, value);
    }
  }
  expect_truth(found, "Y.acceleration", 3.183);
  expect_truth(found, "junction_deviation_mm", 0.0489);
}

/// Stamps that are off by 0.3 ms make feeds of short stretches differ by more than a model that is wrong may.
TEST(Identify, DoesNotTakeTimesThatJitterForAnotherModel) {
  const auto truth = setup_of("linuxcnc-mill", {"X.acceleration=1.3", "Y.acceleration=0.6"});
  Trace trace = *trace_of(truth, 2e-3, 3e-4, 5);
  std::mt19937 random(6);
  std::normal_distribution<double> off(0, 3e-4);
  double squares = 0;
  for (std::size_t i = 1; i < trace.time.size(); ++i) {
    trace.time[i] = std::max(trace.time[i] + off(random), trace.time[i - 1] + 1e-5);
    squares += std::pow(trace.time[i] - trace.time[i - 1] - trace.period, 2);
  }
  trace.jitter = std::sqrt(squares / static_cast<double>(trace.time.size() - 1));
  const auto start = setup_of("linuxcnc-mill", {});
  const FitCases cases{
      std::make_shared<const TraceCase>(std::make_shared<const Trace>(std::move(trace)), program(), start)};
  const Identification found =
      identify(cases, start, fit_parameters_of(start, {"X.acceleration", "Y.acceleration"}));
  EXPECT_TRUE(found.explains);
  for (const auto& [key, value] : {std::pair("X.acceleration", 1.3), std::pair("Y.acceleration", 0.6)}) {
    const IdentifiedParameter one = of(found, key);
    EXPECT_TRUE(one.told) << one.reason;
    EXPECT_NEAR(one.value, value, std::max(0.02 * value, one.uncertainty));
  }
}

TEST(Identify, ReportsAModelThatDoesNotExplainATrace) {
  const auto truth = setup_of("linuxcnc-mill", {});
  const auto start = setup_of("dmg-mori-evo40", {});
  const auto one = std::make_shared<const TraceCase>(trace_of(truth, 1e-3, 1e-4, 6), program(), start);
  const Identification found = identify({one}, start, fit_parameters_of(start, {"X.jerk"}));
  EXPECT_FALSE(found.explains);
  EXPECT_FALSE(found.parameters[0].told);
  EXPECT_THAT(found.parameters[0].reason, HasSubstr("does not explain"));
}

TEST(Identify, CanBeCancelled) {
  const auto setup = setup_of("linuxcnc-mill", {});
  const auto one = std::make_shared<const TraceCase>(trace_of(setup, 1e-3, 1e-4, 6), program(), setup);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(identify({one}, setup, fit_parameters_of(setup, {"X.acceleration"}), {}, &progress),
               Cancelled);
}

/// Section times of the test program as a control would have taken them: in ms, to its period.
class SectionTimes : public testing::Test {
 protected:
  SectionTimes() {
    const IdentificationProgram made = identification_program({Dialect::fanuc, 200, 250});
    ReadOptions reading;
    reading.dialect = Dialect::fanuc;
    program_ =
        load_program(std::make_shared<const SourceText>(SourceText("test.nc", made.text)), nullptr, reading);
    sections_ = made.sections;
  }

  std::string table_of(const feedscope::Setup& setup, double period, unsigned seed) const {
    const feedscope::Run run = simulate_run(program_, setup);
    const LineTimes times(*run.trajectory);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> phase(0, period);
    std::string text = "section,ms\n";
    for (std::size_t section = 1; section <= sections_; ++section) {
      const SectionLines lines =
          ProgramSections(*program_.program->source).lines_of({std::to_string(section), 1, 1, 1}, "table");
      const double begin = phase(random);
      const double time = times.of(lines.first, lines.last).time;
      const double counted = period * (std::floor((begin + time) / period));
      text += std::to_string(section) + "," + std::to_string(std::lround(1e3 * counted)) + "\n";
    }
    return text;
  }

  Identification found(const feedscope::Setup& truth, const feedscope::Setup& start,
                       const std::vector<std::string>& keys, double period = 1e-3, unsigned seed = 1) const {
    const auto one = std::make_shared<const SectionCase>(
        parse_section_times(table_of(truth, period, seed), "times.csv"), "times.csv", program_);
    return identify({one}, start, fit_parameters_of(start, keys));
  }

  LoadedProgram program_;
  std::size_t sections_ = 0;
};

/// So that leaving out a twelfth after the other leaves out every section once, wherever it is.
TEST(SectionCase, MakesEachSectionAStretchOfItsOwn) {
  for (std::size_t count = 1; count <= 40; ++count) {
    std::vector<SectionTime> times;
    for (std::size_t i = 0; i < count; ++i) {
      times.push_back({"1-1", 1, 1e-3, 1});
    }
    const LoadedProgram program =
        load_program(std::make_shared<const SourceText>("line.nc", "G21 G90 G1 X10 F1000\n"));
    const SectionCase sections(times, "times.csv", program);
    std::set<std::size_t> stretches;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_LT(sections.stretch_of(i), count);
      stretches.insert(sections.stretch_of(i));
    }
    EXPECT_EQ(stretches.size(), count);
  }
}

TEST_F(SectionTimes, TellTheLimitsOfAMachineWithoutATrace) {
  const auto truth =
      setup_of("linuxcnc-mill", {"X.acceleration=1.7", "Y.acceleration=1.2", "Z.acceleration=0.5",
                                 "X.velocity=11", "max_linear_velocity_m_min=60", "blend_tolerance_mm=0.05"});
  const auto start = setup_of("linuxcnc-mill", {"max_linear_velocity_m_min=60", "blend_tolerance_mm=0.02"});
  const Identification one =
      found(truth, start,
            {"X.acceleration", "Y.acceleration", "Z.acceleration", "X.velocity", "blend_tolerance_mm"});
  EXPECT_TRUE(one.explains);
  expect_truth(one, "X.acceleration", 1.7);
  expect_truth(one, "Y.acceleration", 1.2);
  expect_truth(one, "Z.acceleration", 0.5);
  expect_truth(one, "X.velocity", 11);
  expect_truth(one, "blend_tolerance_mm", 0.05);
  EXPECT_THAT(one.setup.machine.provenance.at("X.acceleration").source,
              HasSubstr("identified from times.csv"));
  ASSERT_EQ(one.sections.size(), 1U);
  EXPECT_EQ(one.sections[0].size(), sections_);
  EXPECT_NEAR(one.agreements[0].simulated_time, one.agreements[0].measured_time, 0.1);
}

/// Never a confident wrong one: what is told is within 2 % or its stated uncertainty.
TEST_F(SectionTimes, OfACoarseClockAreToldWithinTheirUncertaintyOrNot) {
  const auto truth = setup_of("linuxcnc-mill", {"X.acceleration=1.7", "Y.acceleration=1.2"});
  const auto start = setup_of("linuxcnc-mill", {});
  for (unsigned seed = 1; seed <= test::random_cases(2U); ++seed) {
    const Identification one =
        found(truth, start, {"X.acceleration", "Y.acceleration", "Z.jerk"}, 0.008, seed);
    for (const auto& [key, value] : {std::pair("X.acceleration", 1.7), std::pair("Y.acceleration", 1.2)}) {
      if (of(one, key).told) {
        expect_truth(one, key, value);
        EXPECT_GT(of(one, key).uncertainty, 0);
      }
    }
    EXPECT_FALSE(of(one, "Z.jerk").told);
  }
}

TEST(SectionTable, NamesRowAndFaultOfWhatItCannotRead) {
  const auto refusal = [](const std::string& text) {
    try {
      parse_section_times(text, "t.csv");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  EXPECT_TRUE(is_section_times("# by hand\nsection;seconds\n1;2,5\n"));
  EXPECT_TRUE(is_section_times("Lines,Time [ms]\n"));
  EXPECT_FALSE(is_section_times("time,x,y\n0,1,2\n"));
  const auto german =
      parse_section_times("section;seconds\r\n1;2,5\r\n\r\n2;0,75\r\n3;1\r\n40-55;1,25\r\n", "t.csv");
  ASSERT_EQ(german.size(), 4U);
  EXPECT_DOUBLE_EQ(german[1].seconds, 0.75);
  EXPECT_NEAR(german[1].resolution, 0.25, 1e-12);
  EXPECT_NEAR(parse_section_times("section,ms\n1,1232\n2,848\n3,16\n4,24\n", "t.csv")[0].resolution, 0.008,
              1e-12);
  EXPECT_EQ(german[3].section, "40-55");
  EXPECT_THAT(refusal("a,b\n1,2\n"), HasSubstr("t.csv:1: not a table of section times"));
  EXPECT_THAT(refusal("section,seconds\n1,2\n2,-1\n"),
              HasSubstr("t.csv:3: '2,-1' is not a section and its time"));
  EXPECT_THAT(refusal("section,seconds\n1,2\n"), HasSubstr("section times given: 1; at least 4"));
  EXPECT_THAT(refusal("section,seconds\n1,2\n2,3\n1,2.1\n"),
              HasSubstr("t.csv:4: section 1 has a time in line 2 already"));
}

TEST(FitParameters, AreNumbersOfMachineAndModelByKey) {
  const auto setup = setup_of("linuxcnc-mill", {});
  EXPECT_EQ(fit_parameters_of(setup, {"velocity"}).size(), 3U);
  EXPECT_EQ(fit_parameters_of(setup, {"blend_tolerance_mm"}).front().unit, "mm");
  for (const FitParameter& parameter : usual_fit_parameters(setup)) {
    EXPECT_EQ(parameter.key.find("period"), std::string::npos) << parameter.key;
    EXPECT_FALSE(parameter.key.ends_with("jerk")) << parameter.key << ": LinuxCNC limits none";
  }
  const auto blends = [](const std::string& value) {
    const auto usual = usual_fit_parameters(setup_of("linuxcnc-mill", {"blend_tolerance_mm=" + value}));
    return std::ranges::find(usual, "blend_tolerance_mm", &FitParameter::key) != usual.end();
  };
  EXPECT_TRUE(blends("0.02"));
  EXPECT_FALSE(blends("0")) << "no limit, to which no small value leads";
  const auto with_jerk = usual_fit_parameters(setup_of("spinner-mvc850", {}));
  EXPECT_NE(std::ranges::find(with_jerk, "X.jerk", &FitParameter::key), with_jerk.end());
  try {
    fit_parameters_of(setup, {"X.acceleratoin"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'X.acceleration'?"));
  }
}

}  // namespace
}  // namespace feedscope
