#include "core/analysis/run/run.h"

#include <gmock/gmock.h>

#include "core/analysis/notes/remarks.h"
#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

LoadedProgram corner() {
  return load_program(std::make_shared<const SourceText>("corner.nc", "G1 X20 F3000\nY20\n"));
}

TEST(Setup, OfNothingAskedForIsTheDefaultMachineWithItsModel) {
  const auto setup = make_setup({});
  EXPECT_EQ(setup.machine.id, default_machine);
  EXPECT_EQ(setup.model->info().id, setup.machine.model);
  EXPECT_EQ(setup.settings.number("contour_tolerance_mm"), 0.1);
}

TEST(Setup, TakesToleranceAndAssignmentsInOrder) {
  SetupRequest request;
  request.machine = "mikron-ucp710";
  request.model = "essid";
  request.tolerance = 0.05;
  request.assignments = {"X.jerk=20", "alpha=2", "alpha=3"};
  const auto setup = make_setup(request);
  EXPECT_EQ(setup.settings.number("contour_tolerance_mm"), 0.05);
  EXPECT_EQ(setup.settings.number("alpha"), 3);
  EXPECT_EQ(setup.machine.axes[0].jerk, 20000);
  EXPECT_EQ(setup.machine.axes[1].jerk, 5000);
}

TEST(Setup, NamesWhatIsWrong) {
  const auto asking = [](auto change) {
    return [change] {
      SetupRequest request;
      change(request);
      make_setup(request);
    };
  };
  EXPECT_THAT(asking([](SetupRequest& r) { r.machine = "spiner"; }),
              ThrowsMessage<InputError>(HasSubstr("did you mean 'spinner-mvc850'?")));
  EXPECT_THAT(asking([](SetupRequest& r) { r.model = "esid"; }),
              ThrowsMessage<InputError>(HasSubstr("did you mean 'essid'?")));
  EXPECT_THAT(asking([](SetupRequest& r) { r.tolerance = -1; }),
              ThrowsMessage<InputError>(HasSubstr("tolerance: contour_tolerance_mm = -1 is out of bounds")));
  EXPECT_THAT(asking([](SetupRequest& r) { r.assignments = {"X.jrek=3"}; }),
              ThrowsMessage<InputError>(HasSubstr("did you mean 'X.jerk'?")));
}

TEST(Setup, ToleranceLeavesAModelAloneThatDoesNotReadIt) {
  SetupRequest request;
  request.model = "cam";
  request.tolerance = 0.05;
  EXPECT_FALSE(make_setup(request).settings.has("contour_tolerance_mm"));
}

TEST(Run, SharesTheProgramAndSumsUp) {
  const LoadedProgram program = corner();
  const auto essid = simulate_run(program, make_setup({}));
  SetupRequest baseline;
  baseline.model = "cam";
  const auto cam = simulate_run(program, make_setup(baseline));
  EXPECT_EQ(essid.input.program, cam.input.program);
  EXPECT_EQ(essid.input.toolpath, cam.input.toolpath);
  EXPECT_EQ(essid.trajectory->blend_count(), 1U);
  EXPECT_EQ(essid.summary.cycle_time, essid.trajectory->duration());
  EXPECT_GT(essid.summary.cycle_time, cam.summary.cycle_time);
  EXPECT_DOUBLE_EQ(cam.summary.cycle_time, 0.8);  // 40 mm at 50 mm/s
  EXPECT_DOUBLE_EQ(cam.summary.programmed_time, 0.8);
}

TEST(Run, StopsWhenCancelled) {
  std::string text = "G1 F1000\n";
  for (int i = 0; i < 100000; ++i) {
    text += i % 2 == 0 ? "X1\n" : "X0\n";
  }
  const auto source = std::make_shared<const SourceText>("long.nc", text);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(load_program(source, &progress), Cancelled);
  EXPECT_THROW(simulate_run(load_program(source), make_setup({}), &progress), Cancelled);
}

TEST(Run, AMachinesWorkOffsetsAreReadOrTheRunSaysSo) {
  const auto source = std::make_shared<const SourceText>("two.nc", "G54 G1 X20 Y0 Z0 F3000\nG55 X20 Y0 Z0\n");
  auto setup = make_setup({});
  EXPECT_EQ(unused_work_offsets(*load_program(source).program, setup.machine), "");
  setup.machine.work_offsets.set("G55", Vec3(100, 0, 0));
  setup.machine.work_offsets.set("G59", Vec3(1, 0, 0));
  EXPECT_EQ(unused_work_offsets(*load_program(source).program, setup.machine), "G55");
  const LoadedProgram read = load_program(source, nullptr, reading_on({}, setup.machine));
  EXPECT_EQ(unused_work_offsets(*read.program, setup.machine), "");
  EXPECT_EQ(read.toolpath->bounds.max.x(), 120);
  ReadOptions asked;
  asked.offsets.set("G55", Vec3(7, 0, 0));
  const LoadedProgram own = load_program(source, nullptr, reading_on(asked, setup.machine));
  EXPECT_EQ(own.toolpath->bounds.max.x(), 27) << "what is asked for comes first";
  EXPECT_EQ(unused_work_offsets(*own.program, setup.machine), "G55");
}

}  // namespace
}  // namespace feedscope
