#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/run/run.h"
#include "core/analysis/run/run_stages.h"
#include "core/compressor/compressor.h"

namespace feedscope {
namespace {

/// The cubic Bezier curve of a block G5 from the origin.
struct Bezier {
  Vec3 p1, p2, p3;

  CurvePoint at(double u) const {
    const double w = 1 - u;
    const Vec3 d1 = 3 * w * w * p1 + 6 * w * u * (p2 - p1) + 3 * u * u * (p3 - p2);
    const Vec3 d2 = 6 * w * (p2 - 2 * p1) + 6 * u * (p3 - 2 * p2 + p1);
    return {3 * w * w * u * p1 + 3 * w * u * u * p2 + u * u * u * p3, d1, d2, 6 * (p3 - 3 * p2 + 3 * p1)};
  }
};

const Bezier bezier{{10, 15, 0}, {30, -12, 0}, {40, 5, 0}};
const char* const program = "G21 G90 G17 G64\nG0 X0 Y0\nG5 X40 Y5 I10 J15 P-10 Q-17 F6000\nM2\n";

LoadedProgram read(const std::string& text) {
  ReadOptions options;
  options.dialect = Dialect::linuxcnc;
  return load_program(std::make_shared<const SourceText>("curve.ngc", text), nullptr, options);
}

Run run_with(const std::string& text, const std::string& model, std::vector<std::string> assignments = {}) {
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  request.model = model;
  request.assignments = std::move(assignments);
  return simulate_motion(read(text), make_setup(request));
}

TEST(ProgramCurve, RunsWithItsOwnCurvature) {
  const feedscope::Run run = run_with(program, "essid");
  const BlendedPath& path = run.trajectory->path();
  ASSERT_GT(path.curve_count(), 0U);
  int looked_at = 0;
  for (std::size_t e = 0; e < path.size(); ++e) {
    if (path.kind(e) != ElementKind::curve) {
      continue;
    }
    const ElementCurve curve = path.curve(e);
    for (const double share : {0.1, 0.5, 0.9}) {
      const CurvePoint there = curve.at(share * curve.length);
      double nearest = 1e9;
      double curvature = 0;
      double at = 0;
      for (int i = 0; i <= 4000; ++i) {
        const CurvePoint exact = bezier.at(i / 4000.0);
        if (const double distance = (exact.position - there.position).norm(); distance < nearest) {
          nearest = distance;
          curvature = by_path_length(exact).d2.norm();
          at = i / 4000.0;
        }
      }
      EXPECT_LT(nearest, 0.012) << at;  // half a step of the search
      if (at > 0.1 && at < 0.9) {
        EXPECT_NEAR(there.d2.norm(), curvature, 0.03 * curvature + 0.003) << at;
        ++looked_at;
      }
    }
  }
  EXPECT_GT(looked_at, 20);
}

TEST(ProgramCurve, TakesLittleMoreThanTheLeastTimeOnIt) {
  const double least = run_with(program, "optimal", {"path=essid", "jerk=on"}).trajectory->duration();
  EXPECT_LT(run_with(program, "essid").trajectory->duration(), 1.35 * least);
}

TEST(ProgramCurve, IsRunWhateverTheCompressorDoes) {
  const double time = run_with(program, "essid", {"compressor=off"}).trajectory->duration();
  EXPECT_EQ(run_with(program, "essid", {"compressor=on"}).trajectory->duration(), time);
}

}  // namespace
}  // namespace feedscope
