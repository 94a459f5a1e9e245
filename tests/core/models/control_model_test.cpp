#include "core/models/control_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using ::testing::HasSubstr;

template <typename F>
std::string message_of(F call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FindModel, NamesTheNearestIdForAWrongOne) {
  EXPECT_EQ(find_model("cam").info().id, "cam");
  EXPECT_THAT(message_of([] { find_model("esid"); }), HasSubstr("did you mean 'essid'?"));
}

TEST(ControlModel, LaysThePathThatItRuns) {
  std::mt19937 random(12);
  const Machine machine = testing::spinner();
  for (int i = 0; i < 10; ++i) {
    const auto path = std::make_shared<const Toolpath>(testing::random_path(random, 30));
    for (const ControlModel* model : all_models()) {
      const Settings settings = complete_settings(*model, machine);
      const BlendedPath run = model->simulate(path, machine, settings).path();
      const BlendedPath laid = model->lay_path(on_machine(path, machine, settings), machine, settings).path();
      ASSERT_EQ(laid.size(), run.size()) << model->info().id;
      for (std::size_t e = 0; e < run.size(); ++e) {
        ASSERT_EQ(laid.kind(e), run.kind(e)) << model->info().id;
        ASSERT_EQ(laid.segment(e), run.segment(e)) << model->info().id;
        ASSERT_EQ(laid.s(e), run.s(e)) << model->info().id;
        ASSERT_EQ(laid.element(e).start, run.element(e).start) << model->info().id;
        ASSERT_EQ(laid.element(e).end, run.element(e).end) << model->info().id;
      }
      ASSERT_EQ(laid.length(), run.length()) << model->info().id;
    }
  }
}

TEST(CompleteSettings, TakesTheMachineThenTheFallback) {
  const ControlModel& essid = find_model("essid");
  Machine machine = testing::spinner();
  machine.settings.set("contour_tolerance_mm", 0.03);
  machine.settings.set("curvilinear_jerk_m_s3", 10.0);
  const Settings settings = complete_settings(essid, machine);
  EXPECT_EQ(settings.number("contour_tolerance_mm"), 0.03);
  EXPECT_EQ(settings.number("alpha"), 2.5);
  EXPECT_EQ(settings.text("reading"), "corrected");
  EXPECT_FALSE(settings.has("curvilinear_jerk_m_s3")) << "the model does not use it";
}

TEST(ApplySetting, SetsAxisLimitsAndSettings) {
  const ControlModel& essid = find_model("essid");
  Machine machine = testing::spinner();
  Settings settings = testing::spinner_settings(essid);
  apply_setting("X.jerk=20", essid, machine, settings);
  apply_setting("beta=1", essid, machine, settings);
  apply_setting("reading=strict", essid, machine, settings);
  EXPECT_DOUBLE_EQ(machine.axes[0].jerk, 20000);
  EXPECT_EQ(settings.number("beta"), 1);
  EXPECT_EQ(settings.text("reading"), "strict");
}

TEST(ApplySetting, ExplainsWhatIsWrong) {
  const ControlModel& essid = find_model("essid");
  Machine machine = testing::spinner();
  Settings settings = testing::spinner_settings(essid);
  const auto message = [&](const std::string& text) {
    return message_of([&] { apply_setting(text, essid, machine, settings); });
  };
  EXPECT_THAT(message("alpha"), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(message("aplha=2"), HasSubstr("did you mean 'alpha'?"));
  EXPECT_THAT(message("X.jrek=2"), HasSubstr("did you mean 'X.jerk'?"));
  EXPECT_THAT(message("X.jerk=-2"), HasSubstr("-2"));
  EXPECT_THAT(message("alpha=9"), HasSubstr("3.5"));
  EXPECT_THAT(message("reading=loose"), HasSubstr("published"));
}

TEST(Simulate, RefusesAnAxisThatMovesWithoutLimits) {
  Machine machine = testing::spinner();
  machine.axes[2].jerk = 0;
  const ControlModel& essid = find_model("essid");
  const auto run = [&](const Vec3& end) {
    essid.simulate(testing::polyline({{0, 0, 0}, end}, 50), machine, testing::spinner_settings(essid));
  };
  EXPECT_NO_THROW(run({10, 0, 0}));
  EXPECT_THAT(message_of([&] { run({10, 0, 1}); }), HasSubstr("axis Z moves"));
}

TEST(Simulate, StopsWhenCancelled) {
  std::vector<Vec3> points;
  for (int i = 0; i < 100000; ++i) {
    points.push_back({0.1 * i, i % 2 == 0 ? 0.0 : 0.1, 0});
  }
  const Toolpath path = testing::polyline(points, 50);
  for (const ControlModel* model : all_models()) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(model->simulate(path, testing::spinner(), testing::spinner_settings(*model), &progress),
                 Cancelled)
        << model->info().id;
  }
}

}  // namespace
}  // namespace feedscope
