#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "core/analysis/run/run.h"
#include "core/analysis/run/run_stages.h"

namespace feedscope {
namespace {

constexpr int rows_a_block = 100;  // a block of rows is one of equal parts of the program
constexpr int points_a_row = 100;
constexpr int blocks = 4;  // long programs are run in parts of some 8000 blocks, on several cores

/// Rows of short lines with an arc, a sharp corner and a rapid back; `times` equal blocks of them.
std::string rows(int times) {
  std::string text = "G17 G21 G90 G94\nG0 X0 Y0 Z0\n";
  for (int row = 0; row < times * rows_a_block; ++row) {
    text += "G4 P10\nG1 F5000 Y1\n";
    for (int i = 1; i <= points_a_row; ++i) {
      text += fmt::format("X{:.4f} Y{:.4f}\n", 0.2 * i, 1 + std::sin(0.2 * i / 2));
    }
    text += fmt::format("G2 X{0:.4f} Y{1:.4f} I1 J0\nG1 Y9\nX0\nG0 Y0\n", 0.2 * points_a_row + 2,
                        1 + std::sin(0.1 * points_a_row));
  }
  return text + "M30\n";
}

struct ModelCase {
  const char* model;
  std::vector<std::string> settings;
};

void PrintTo(const ModelCase& c, std::ostream* out) {
  *out << c.model << " " << fmt::format("{}", fmt::join(c.settings, " "));
}

Setup setup_of(const ModelCase& c) {
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  request.model = c.model;
  request.assignments = c.settings;
  return make_setup(request);
}

LoadedProgram loaded(int times) {
  return load_program(std::make_shared<const SourceText>("rows.nc", rows(times)));
}

class LongProgram : public ::testing::TestWithParam<ModelCase> {};

/// Every part of it is at rest at both ends, so that it runs as if it were alone.
TEST_P(LongProgram, IsTheSumOfItsParts) {
  const feedscope::Run one = simulate_motion(loaded(1), setup_of(GetParam()));
  const feedscope::Run all = simulate_motion(loaded(blocks), setup_of(GetParam()));
  const Trajectory& part = *one.trajectory;
  const Trajectory& whole = *all.trajectory;
  EXPECT_NEAR(whole.duration(), blocks * part.duration(), 1e-9 * whole.duration());
  EXPECT_NEAR(whole.path_length(), blocks * part.path_length(), 1e-9 * whole.path_length());
  EXPECT_EQ(whole.blend_count(), blocks * part.blend_count());
  EXPECT_EQ(whole.path().curve_count(), blocks * part.path().curve_count());
  ASSERT_GT(whole.path().programmed()->segments.size(), 40000U) << "several parts";
  ASSERT_EQ(whole.path().size(), blocks * part.path().size());
  for (int k = 0; k < blocks; ++k) {
    for (std::size_t i = 0; i < part.path().size(); i += 7) {
      const PathElement alone = part.path().element(i);
      const PathElement there = whole.path().element(static_cast<std::size_t>(k) * part.path().size() + i);
      ASSERT_EQ(there.kind, alone.kind) << k << " " << i;
      ASSERT_LT((there.start - alone.start).norm() + (there.end - alone.end).norm(), 1e-9) << k << " " << i;
    }
    for (int i = 0; i <= 500; ++i) {
      const double t = part.duration() * i / 500.001;
      const State alone = part.state(t);
      const State there = whole.state(k * part.duration() + t);
      ASSERT_LT((there.position - alone.position).norm(), 1e-6) << k << " at " << t;
      ASSERT_NEAR(there.speed, alone.speed, 1e-3) << k << " at " << t;
    }
    for (std::size_t i = 0; i < part.blend_count(); i += 97) {
      const BlendRecord alone = part.blend(i);
      const BlendRecord there = whole.blend(static_cast<std::size_t>(k) * part.blend_count() + i);
      ASSERT_LT((there.corner - alone.corner).norm(), 1e-9);
      ASSERT_NEAR(there.epsilon, alone.epsilon, 1e-9);
    }
  }
}

TEST_P(LongProgram, IsTheSameEveryTime) {
  const LoadedProgram program = loaded(blocks);
  const feedscope::Setup setup = setup_of(GetParam());
  const feedscope::Run first = simulate_motion(program, setup);
  const feedscope::Run second = simulate_motion(program, setup);
  const auto& pieces = first.trajectory->pieces();
  const auto& again = second.trajectory->pieces();
  ASSERT_EQ(pieces.size(), again.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ASSERT_EQ(pieces[i].time, again[i].time);
    ASSERT_EQ(pieces[i].q, again[i].q);
    ASSERT_EQ(pieces[i].v, again[i].v);
    ASSERT_EQ(pieces[i].element, again[i].element);
  }
}

TEST_P(LongProgram, IsGivenUpWhenAskedTo) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(simulate_motion(loaded(blocks), setup_of(GetParam()), &progress), Cancelled);
}

INSTANTIATE_TEST_SUITE_P(Models, LongProgram,
                         ::testing::Values(ModelCase{"essid", {}}, ModelCase{"essid", {"compressor=on"}},
                                           ModelCase{"msaddek", {}},
                                           ModelCase{"msaddek", {"compaction_mm=1"}},
                                           ModelCase{"gassara", {}}, ModelCase{"tapie", {}},
                                           ModelCase{"ward", {}}, ModelCase{"ward", {"compressor=on"}}));

}  // namespace
}  // namespace feedscope
