#include "core/identification/recordings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/analysis/time/line_times.h"
#include "core/base/error.h"
#include "core/drives/drive_response.h"
#include "core/machine/machine.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

LoadedProgram moves() {
  return load_program(std::make_shared<const SourceText>(SourceText(
      "moves.nc", "G21 G90\nG1 X30 F6000\nG4 P0.1\nX0\nG4 P0.1\nY30\nG4 P0.1\nX20 Y0\nG4 P0.1\nX0\nM30\n")));
}

Setup mill(const std::vector<std::string>& settings, const std::string& model = "linuxcnc") {
  SetupRequest request;
  request.machine = "linuxcnc-mill";
  request.model = model;
  request.assignments = settings;
  return make_setup(request);
}

std::shared_ptr<const Trace> trace_of(const Run& run, bool mirrored = false) {
  const MotionRecord record = record_of(*run.trajectory, 1e-3);
  Trace trace;
  trace.name = "scope.csv";
  trace.period = 1e-3;
  trace.time = record.time;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Vec3& place : record.place) {
      trace.place[static_cast<std::size_t>(axis)].push_back(mirrored && axis == 0 ? -place[axis]
                                                                                  : place[axis]);
    }
  }
  return std::make_shared<const Trace>(std::move(trace));
}

/// With drives, of which X and Y are recorded.
std::shared_ptr<const Trace> trace_with_drives(const Run& run) {
  const DriveResponse response(run.trajectory, run.setup.machine);
  ActualWalk walk(response);
  Trace trace = *trace_of(run);
  for (const double time : trace.time) {
    const Vec3 actual = walk.at(time).position;
    trace.actual[0].push_back(actual.x());
    trace.actual[1].push_back(actual.y());
  }
  return std::make_shared<const Trace>(std::move(trace));
}

const std::vector<std::string> truth{"X.acceleration=1.3", "Y.acceleration=0.6"};

/// Both kinds explain one machine, each with its own program.
TEST(Recordings, OfTracesAndSectionTimesAreExplainedTogether) {
  const LoadedProgram program = moves();
  const auto run = simulate_run(program, mill(truth));
  const LineTimes times(*run.trajectory);
  std::vector<SectionTime> sections;
  for (std::uint32_t line = 2; line <= 10; line += 2) {
    sections.push_back({fmt::format("{}-{}", line, line), times.of(line, line).time, 1e-4, line});
  }
  Recordings recordings;
  recordings.add(trace_of(run), program);
  recordings.add(sections, "times.csv", program);
  ASSERT_EQ(recordings.size(), 2U);
  std::vector<std::string> stages;
  Progress progress;
  const auto start = mill({});
  const Identification found = recordings.fit(
      start, fit_parameters_of(start, {"X.acceleration", "Y.acceleration"}), {}, [&](const char* title) {
        stages.emplace_back(title);
        return &progress;
      });
  EXPECT_THAT(stages, ElementsAre("matching", "fitting"));
  EXPECT_TRUE(found.explains);
  EXPECT_NEAR(found.parameters[0].value, 1.3, 0.013);
  EXPECT_NEAR(found.parameters[1].value, 0.6, 0.006);
  ASSERT_EQ(found.agreements.size(), 2U);
  EXPECT_TRUE(found.sections[0].empty());
  EXPECT_EQ(found.sections[1].size(), sections.size());
  EXPECT_THAT(found.setup.machine.provenance.at("X.acceleration").source,
              HasSubstr("identified from scope.csv, times.csv"));
}

TEST(Recordings, WithActualPositionsTellTheDrivesToo) {
  const LoadedProgram program = moves();
  std::vector<std::string> settings = truth;
  settings.insert(settings.end(), {"X.kv=40", "X.velocity_feedforward=0.5", "X.velocity_lag=4", "Y.kv=55"});
  Recordings recordings;
  recordings.add(trace_with_drives(simulate_run(program, mill(settings))), program);
  const auto start = mill({"Y.kv=30"});
  std::vector<std::string> keys;
  for (const FitParameter& one : recordings.usual_parameters(start)) {
    keys.push_back(one.key);
  }
  EXPECT_THAT(keys,
              IsSupersetOf({"X.acceleration", "X.kv", "X.velocity_feedforward", "X.velocity_lag", "Y.kv"}));
  EXPECT_THAT(keys, Not(Contains("Z.kv")));
  IdentifyOptions options;
  options.date = "2026-11-27";
  const Identification found = recordings.fit(
      start,
      fit_parameters_of(start, {"X.acceleration", "Y.acceleration", "X.kv", "X.velocity_feedforward",
                                "X.velocity_lag", "Y.kv", "Y.velocity_feedforward", "Y.velocity_lag"}),
      options);
  ASSERT_EQ(found.drives.size(), 2U);
  ASSERT_EQ(found.parameters.size(), 8U);
  EXPECT_EQ(found.parameters[0].parameter.key, "X.acceleration");
  EXPECT_NEAR(found.parameters[0].value, 1.3, 0.013);
  EXPECT_EQ(found.parameters[2].parameter.key, "X.kv");
  EXPECT_NEAR(found.parameters[2].value, 40, 0.4);
  EXPECT_NEAR(found.parameters[3].value, 0.5, 0.01);
  EXPECT_NEAR(found.parameters[4].value, 4, 0.1);
  EXPECT_EQ(found.parameters[5].start, 30);
  EXPECT_NEAR(found.parameters[5].value, 55, 0.5);
  EXPECT_FALSE(found.parameters[6].told) << "there is none";
  EXPECT_EQ(found.parameters[6].told_by, "") << "no trace tells a gain alone from others";
  const Machine& machine = found.setup.machine;
  EXPECT_NEAR(*machine.drives.find('Y')->gain, 55, 0.5);
  EXPECT_FALSE(machine.drives.find('Y')->feedforward);
  EXPECT_THAT(machine.provenance.at("X.kv").source, HasSubstr("identified from scope.csv, 2026-11-27, 40"));
  EXPECT_FALSE(machine.provenance.at("X.kv").assumed);
  EXPECT_TRUE(has_drives(found.runs.front().setup.machine)) << "the run has the drives that were found";
}

TEST(Recordings, TellDrivesAloneWithoutAnySearch) {
  const LoadedProgram program = moves();
  Recordings recordings;
  recordings.add(trace_with_drives(simulate_run(program, mill({"X.kv=40", "Y.kv=40"}))), program);
  const auto start = mill({});
  const Identification found = recordings.fit(start, fit_parameters_of(start, {"kv"}));
  EXPECT_NEAR(found.parameters.front().value, 40, 0.4);
  EXPECT_TRUE(found.explains);
  EXPECT_EQ(found.agreements.size(), 1U);
}

/// The feed of 6 m/min is as fast as these moves become: nothing shows what the axis could do.
TEST(Recordings, ThatDoNotReachALimitLeaveItOrTakeTheSmallestThatExplainsThem) {
  const LoadedProgram program = moves();
  std::vector<std::string> settings = truth;
  settings.insert(settings.end(), {"X.velocity=20", "max_linear_velocity_m_min=20"});
  Recordings recordings;
  recordings.add(trace_of(simulate_run(program, mill(settings))), program);
  const auto found_from = [&](const char* velocity) {
    const auto start = mill({velocity, "max_linear_velocity_m_min=20"});
    const Identification found =
        recordings.fit(start, fit_parameters_of(start, {"X.acceleration", "Y.acceleration", "X.velocity"}));
    return *std::ranges::find(found.parameters, "X.velocity",
                              [](const IdentifiedParameter& one) { return one.parameter.key; });
  };
  const IdentifiedParameter fast = found_from("X.velocity=30");
  EXPECT_EQ(fast.parameter.key, "X.velocity");
  EXPECT_FALSE(fast.told);
  EXPECT_EQ(fast.value, 30);
  const IdentifiedParameter slow = found_from("X.velocity=2");
  EXPECT_FALSE(slow.told);
  ASSERT_TRUE(slow.at_least);
  EXPECT_NEAR(*slow.at_least, 6, 0.1);
  EXPECT_NEAR(slow.value, 6, 0.2);
}

/// Else a velocity of the machine stands for the override.
TEST(Recordings, OfOneFeedOverrideAreExplainedWithIt) {
  const LoadedProgram program = moves();
  std::vector<std::string> settings = truth;
  settings.emplace_back("feed_override_percent=30");
  Recordings recordings;
  recordings.add(trace_of(simulate_run(program, mill(settings))), program);
  const auto start = mill({});
  const Identification found = recordings.fit(
      start, fit_parameters_of(start, {"X.acceleration", "Y.acceleration", "max_linear_velocity_m_min"}));
  EXPECT_TRUE(found.explains);
  for (const IdentifiedParameter& one : found.parameters) {
    EXPECT_EQ(one.told, one.parameter.key.ends_with("acceleration")) << one.parameter.key;
  }
  EXPECT_NEAR(found.parameters[0].value, 1.3, 0.013);
  EXPECT_EQ(found.parameters.back().parameter.key, "feed_override_percent");
  EXPECT_NEAR(found.parameters.back().value, 30, 0.1);
  EXPECT_THAT(write_machine(identified_machine(found, "mill.toml")), Not(HasSubstr("feed_override_percent")));
  EXPECT_EQ(recordings.remarks()[0].front().code, "trace-override");
}

/// At 2 ms, read as 1 ms: the limits would be 2 and 4 times those of the machine.
TEST(Recordings, WithAWrongRateAreRefusedWithTheRightOne) {
  const LoadedProgram program = moves();
  Trace trace = *trace_of(simulate_run(program, mill(truth)));
  for (double& time : trace.time) {
    time /= 2;
  }
  trace.period /= 2;
  const auto refusal = [&](TraceClock clock) {
    trace.clock = clock;
    Recordings recordings;
    recordings.add(std::make_shared<const Trace>(trace), program);
    const auto start = mill({});
    try {
      recordings.fit(start, fit_parameters_of(start, {"X.acceleration"}));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("fitted");
  };
  for (const TraceClock clock : {TraceClock::option, TraceClock::machine, TraceClock::assumed}) {
    EXPECT_THAT(refusal(clock),
                HasSubstr("scope.csv: no limits can be found from this trace: the trace runs at "
                          "200 % of the programmed feed"));
    EXPECT_THAT(refusal(clock), HasSubstr("rate=1000"));
  }
  EXPECT_EQ(refusal(TraceClock::times), "fitted") << "that may be an override";
}

/// Drives are looked for once; a trace that is added later counts all the same, and so does another start.
TEST(Recordings, TellTheSameDriveWithEveryModelAndAnotherOneFromMoreTraces) {
  const LoadedProgram program = moves();
  Recordings recordings;
  recordings.add(trace_with_drives(simulate_run(program, mill({"X.kv=40", "Y.kv=40"}))), program);
  const auto fit = [&](const std::vector<std::string>& settings, const std::string& model) {
    const auto start = mill(settings, model);
    return recordings.fit(start, fit_parameters_of(start, {"X.kv"}));
  };
  const Identification first = fit({}, "linuxcnc");
  const Identification other_model = fit({}, "cam");
  EXPECT_EQ(other_model.parameters.front().value, first.parameters.front().value);
  EXPECT_EQ(other_model.drives.front().samples, first.drives.front().samples);
  EXPECT_EQ(fit({"X.kv=70"}, "cam").parameters.front().start, 70);
  recordings.add(trace_with_drives(simulate_run(program, mill({"X.kv=80", "Y.kv=40"}))), program);
  const Identification more = fit({}, "linuxcnc");
  EXPECT_GT(more.drives.front().samples, first.drives.front().samples);
  EXPECT_NE(more.parameters.front().value, first.parameters.front().value);
}

TEST(Recordings, WithoutActualPositionsTellNoDrive) {
  const LoadedProgram program = moves();
  Recordings recordings;
  recordings.add(trace_of(simulate_run(program, mill({}))), program);
  const auto start = mill({});
  try {
    recordings.fit(start, fit_parameters_of(start, {"X.kv"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("X.kv is found from set and actual positions of X"));
    EXPECT_THAT(error.what(), HasSubstr("--columns actual_x="));
  }
}

TEST(Recordings, SayWhatIsWrongWithATraceOnItsProgram) {
  const LoadedProgram program = moves();
  Recordings recordings;
  recordings.add(trace_of(simulate_run(program, mill(truth)), true), program);
  const auto start = mill({});
  recordings.fit(start, fit_parameters_of(start, {"X.acceleration"}));
  ASSERT_EQ(recordings.remarks().size(), 1U);
  ASSERT_FALSE(recordings.remarks()[0].empty());
  EXPECT_THAT(recordings.remarks()[0][0].message.english(), HasSubstr("axis X of the trace is mirrored"));
}

/// As a feed hold of three seconds in the middle of a move leaves it.
TEST(Recordings, AreComparedWithoutAStretchInWhichTheMachineWasHeld) {
  const LoadedProgram program = moves();
  Trace held = *trace_of(simulate_run(program, mill(truth)));
  constexpr double hold = 3;
  const auto at = static_cast<std::size_t>(0.2 / held.period);  // in the move of line 2
  for (std::size_t i = at; i < held.size(); ++i) {
    held.time[i] += hold;
  }
  for (std::size_t n = 1; n < static_cast<std::size_t>(hold / held.period); ++n) {
    const auto place = static_cast<std::ptrdiff_t>(at);
    held.time.insert(held.time.begin() + place,
                     held.time[at - 1] + hold - static_cast<double>(n) * held.period);
    for (auto& axis : held.place) {
      axis.insert(axis.begin() + place, axis[at - 1]);
    }
  }
  Recordings recordings;
  recordings.add(std::make_shared<const Trace>(held), program);
  const auto start = mill({});
  const Identification found =
      recordings.fit(start, fit_parameters_of(start, {"X.acceleration", "Y.acceleration"}));
  EXPECT_TRUE(found.explains);
  EXPECT_NEAR(found.parameters[0].value, 1.3, 0.026);
  EXPECT_NEAR(found.parameters[1].value, 0.6, 0.012);
  EXPECT_NEAR(found.agreements[0].time_error(), 0, 0.01);
  ASSERT_EQ(recordings.remarks()[0].size(), 1U);
  EXPECT_EQ(recordings.remarks()[0][0].code, "trace-held");
  EXPECT_THAT(recordings.remarks()[0][0].message.english(),
              HasSubstr("stands still for 3 s from 0.199 s on at line 2"));
}

/// G64 without P, as a control has it that begins with it.
TEST(Recordings, OfAControlWithoutABlendToleranceAreExplainedByZero) {
  const LoadedProgram program =
      load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs/lesson_corners.nc");
  const auto run =
      simulate_run(program, mill({"X.acceleration=0.25", "Y.acceleration=0.3", "blend_tolerance_mm=0"}));
  Recordings recordings;
  recordings.add(trace_of(run), program);
  const auto start = mill({"Y.acceleration=0.3"});
  const Identification found =
      recordings.fit(start, fit_parameters_of(start, {"X.acceleration", "blend_tolerance_mm"}));
  EXPECT_TRUE(found.explains);
  EXPECT_NEAR(found.parameters[0].value, 0.25, 0.005);
  EXPECT_EQ(found.setup.settings.number("blend_tolerance_mm"), 0);
  const IdentifiedParameter& tolerance = found.parameters.back();
  EXPECT_EQ(tolerance.parameter.key, "blend_tolerance_mm");
  EXPECT_EQ(tolerance.value, 0);
  EXPECT_THAT(tolerance.reason, HasSubstr("Only zero"));
}

/// What comes closest says nothing of the machine.
TEST(Recordings, OfAnotherKindOfControlLeaveTheMachineFileAsItWas) {
  const LoadedProgram program = moves();
  Recordings recordings;
  recordings.add(trace_of(simulate_run(program, mill(truth))), program);
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  const auto start = make_setup(request);
  const Identification found =
      recordings.fit(start, fit_parameters_of(start, {"X.velocity", "filter_time_s"}));
  ASSERT_FALSE(found.explains);
  const Machine machine = identified_machine(found, "mine.toml");
  int changed = 0;
  for (const IdentifiedParameter& one : found.parameters) {
    changed += one.value != one.start ? 1 : 0;
    auto written = start;
    written.machine = machine;
    written.settings = complete_settings(*start.model, machine);
    EXPECT_DOUBLE_EQ(fit_value(written, one.parameter), one.start) << one.parameter.key;
    EXPECT_EQ(machine.provenance.at(one.parameter.key).source,
              start.machine.provenance.at(one.parameter.key).source);
  }
  EXPECT_GT(changed, 0) << "it comes closer with other numbers";
}

/// A search for the machine that takes so long would go on for minutes, and find nothing.
TEST(Recordings, WithTimesThatNoMachineTakesAreRefusedWithWhatTheySeemToBe) {
  const LoadedProgram program = moves();
  const auto run = simulate_run(program, mill(truth));
  const LineTimes times(*run.trajectory);
  const auto refusal = [&](double factor) {
    std::vector<SectionTime> sections;
    for (std::uint32_t line = 2; line <= 10; line += 2) {
      sections.push_back({fmt::format("{}-{}", line, line), factor * times.of(line, line).time, 1e-4, line});
    }
    Recordings recordings;
    recordings.add(sections, "times.csv", program);
    const auto start = mill({});
    try {
      recordings.fit(start, fit_parameters_of(start, {"X.acceleration"}));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("fitted");
  };
  EXPECT_THAT(refusal(1000), HasSubstr("times.csv: the sections take "));
  EXPECT_THAT(refusal(1000), HasSubstr("they seem to be in ms: give their column the title ms"));
  EXPECT_THAT(refusal(1e-3), HasSubstr("they seem to be in s: give their column the title seconds"));
  EXPECT_THAT(refusal(1.0 / 60), HasSubstr("they seem to be in minutes"));
  EXPECT_THAT(refusal(30), HasSubstr("give the program that ran"));
  EXPECT_EQ(refusal(3), "fitted");
}

TEST(Recordings, OfAnotherProgramAreRefused) {
  const auto run = simulate_run(moves(), mill({}));
  Recordings recordings;
  recordings.add(trace_of(run), load_program(std::make_shared<const SourceText>(SourceText(
                                    "other.nc", "G21 G90\nG1 X100 Y300 F6000\nZ40\nX-70\nM30\n"))));
  const auto start = mill({});
  try {
    recordings.fit(start, fit_parameters_of(start, {"X.acceleration"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("scope.csv: the trace does not belong to its program"));
  }
}

TEST(Recordings, TheModelThatExplainsBestComesFirst) {
  std::vector<Identification> models(3);
  models[0].residual = 3;
  models[1].residual = 1;
  models[2].residual = 2;
  sort_by_explanation(models);
  EXPECT_EQ(models[0].residual, 1);
  EXPECT_EQ(models[2].residual, 3);
}

TEST(Recordings, AModelThatLeavesMuchMoreOverThanTheBestExplainsThemRoughly) {
  Identification best;
  best.explains = true;
  best.residual = 1.1;
  Identification near = best;
  near.residual = 2;
  Identification far = best;
  far.residual = 28;
  EXPECT_FALSE(explains_roughly(best, best));
  EXPECT_FALSE(explains_roughly(near, best));
  EXPECT_TRUE(explains_roughly(far, best));
  far.explains = false;
  EXPECT_FALSE(explains_roughly(far, best)) << "it does not at all";
}

TEST(Recordings, AMachineIsNamedAfterItsFile) {
  Identification found;
  found.setup = mill({});
  EXPECT_EQ(identified_machine(found, "/some/where/my-mill.toml").id, "my-mill");
  EXPECT_EQ(identified_machine(found, "/some/where/my-mill.toml").name, "my-mill");
  EXPECT_EQ(identified_machine(found, "-").id, "linuxcnc-mill");
}

TEST(Recordings, BeginWithAMachineOfTheModelsControl) {
  EXPECT_EQ(usual_machine_of("linuxcnc"), "linuxcnc-mill");
  EXPECT_EQ(usual_machine_of("ward"), "dmg-mori-evo40");
  EXPECT_EQ(usual_machine_of("cam"), default_machine) << "of no control";
}

TEST(Recordings, TablesAreKnownByTheirHead) {
  const auto file = std::filesystem::temp_directory_path() / "feedscope-section-times.csv";
  std::ofstream(file) << "section,ms\n1,100\n2,200\n3,300\n4,404\n";
  EXPECT_TRUE(is_section_times_file(file));
  EXPECT_EQ(read_section_times(file).size(), 4U);
  std::ofstream(file) << "time,x,y\n0,1,2\n";
  EXPECT_FALSE(is_section_times_file(file));
  std::filesystem::remove(file);
  EXPECT_FALSE(is_section_times_file(file));
  EXPECT_THROW(read_section_times(file), InputError);
}

TEST(IdentificationStage, SaysInOrderWhatIsDone) {
  EXPECT_EQ(identification_stage(0), "what the axes reach");
  EXPECT_EQ(identification_stage(0.1), "each number alone");
  EXPECT_EQ(identification_stage(0.5), "all numbers together");
  EXPECT_EQ(identification_stage(1), "uncertainties");
}

}  // namespace
}  // namespace feedscope
