#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "core/identification/identify.h"
#include "core/identification/trace_case.h"
#include "core/trace/read_trace.h"
#include "tests/support/folders.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

fs::path traces() {
  return fs::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "linuxcnc" / "traces";
}

/// A program without its G64 P0.02, which is then to be found.
LoadedProgram without_tolerance(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(traces() / (name + ".ngc")).rdbuf();
  std::string program = text.str();
  const auto place = program.find("G64 P0.02");
  if (place != std::string::npos) {
    program.replace(place, 9, "");
  }
  return load_program(std::make_shared<const SourceText>(SourceText(name + ".ngc", program)));
}

std::shared_ptr<const Trace> trace_of(const std::string& name) {
  return std::make_shared<const Trace>(
      read_trace(traces() / (name + ".txt.gz"), parse_trace_columns("linuxcnc")));
}

/// The machine that the traces were recorded on, from one that is far from it.
TEST(LinuxCncIdentification, FindsTheMachineOfItsTraces) {
  if (!test::thorough()) {
    GTEST_SKIP() << "a minute; IdentificationViewTest finds it from one of the traces";
  }
  if (!fs::exists(traces() / "msaddek_pocket.txt.gz")) {
    GTEST_SKIP() << "no traces of LinuxCNC at " << traces();
  }
  SetupRequest request;
  request.machine = "linuxcnc-mill";
  const auto start = make_setup(request);
  FitCases cases;
  for (const std::string name : {"tapie_bore", "lesson_corners"}) {
    cases.push_back(std::make_shared<const TraceCase>(trace_of(name), without_tolerance(name), start));
  }
  const Identification found =
      identify(cases, start,
               fit_parameters_of(
                   start, {"velocity", "acceleration", "blend_tolerance_mm", "max_linear_velocity_m_min"}));
  EXPECT_TRUE(found.explains);
  const std::map<std::string, std::pair<double, double>> truth{
      {"X.velocity", {10, 0.01}},    {"Y.velocity", {10, 0.01}},      {"X.acceleration", {1, 0.01}},
      {"Y.acceleration", {1, 0.01}}, {"Z.acceleration", {0.4, 0.01}}, {"blend_tolerance_mm", {0.02, 0.05}}};
  std::size_t told = 0;
  for (const IdentifiedParameter& one : found.parameters) {
    const auto known = truth.find(one.parameter.key);
    if (one.told) {
      ASSERT_NE(known, truth.end()) << one.parameter.key << " is not told by these traces";
      EXPECT_NEAR(one.value / known->second.first, 1, known->second.second) << one.parameter.key;
      ++told;
    }
  }
  EXPECT_GE(told, 5U);
  // Programs that were not used.
  for (const std::string name : {"msaddek_pocket", "essid_spline", "lesson_zigzag_6000"}) {
    const LoadedProgram program = load_program(traces() / (name + ".ngc"));
    const TraceCase other(trace_of(name), program, found.setup);
    const Agreement agreement =
        agreement_of(other.found(), other.course(), simulate_run(program, found.setup));
    EXPECT_LT(std::abs(agreement.time_error()), 0.005) << name;
  }
}

}  // namespace
}  // namespace feedscope
