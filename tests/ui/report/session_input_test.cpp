#include "ui/report/session_input.h"

#include <gtest/gtest.h>

#include "tests/ui/identification_fixture.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/pictures.h"
#include "ui/report/scene_picture.h"

namespace feedscope::ui {
namespace {

Session session_of(const ReportInput& input) {
  Session session;
  for (const ReportRun& run : input.runs) {
    const int id = static_cast<int>(session.runs.size()) + 1;
    session.runs.push_back({id, {}, run.colour, true, SetupState(run.shown->run.setup)});
  }
  session.runs[1].name = "roughing";
  session.current_run = 1;
  session.annotations = {test::note("here")};
  return session;
}

TEST(SessionInput, ShowsWhatTheSessionHolds) {
  const ReportInput two = test::two_runs();
  Session session = session_of(two);
  session.scene.colouring = Colouring::cause;
  session.scene.camera = {Vec3(10, 5, 0), 0.3, 0.9, 12, false, false};
  session.identification.result = {test::some_outcome(), 1, false};
  const ReportInput input = report_input(session, {two.runs[0].shown, two.runs[1].shown});
  EXPECT_EQ(input.run().name, "roughing");
  EXPECT_EQ(input.identification.outcome, session.identification.result.outcome);
  EXPECT_EQ(input.identification.chosen, 1U);
  EXPECT_EQ(input.runs[0].name, "essid, 0.01 mm");
  EXPECT_EQ(input.annotations.size(), 1U);
  ScenePicture picture(input, input.current, ThemeKind::light);
  picture.image({400, 300}, {});
  EXPECT_NEAR(picture.scene().camera().height, 12, 1e-9);
  EXPECT_EQ(picture.scene().colouring(), Colouring::cause);
}

TEST(SessionInput, WithoutAViewOfItsOwnItIsSeenAsUsual) {
  const ReportInput two = test::two_runs();
  EXPECT_EQ(report_input(session_of(two), {two.runs[0].shown, two.runs[1].shown}).view, StandardView::iso);
}

TEST(SessionInput, ARunThatCouldNotBeMadeIsLeftOut) {
  const ReportInput two = test::two_runs();
  const ReportInput input = report_input(session_of(two), {nullptr, two.runs[1].shown});
  ASSERT_EQ(input.runs.size(), 1U);
  EXPECT_EQ(input.run().name, "roughing");
}

TEST(SessionInput, TheSameSessionGivesTheSameSheet) {
  const ReportInput two = test::two_runs();
  PictureRequest request;
  request.format = PictureFormat::pdf;
  request.size = {1123, 794};
  const auto drawn = [&] {
    return sheet_file(report_input(session_of(two), {two.runs[0].shown, two.runs[1].shown}), request);
  };
  EXPECT_EQ(drawn(), drawn());
}

}  // namespace
}  // namespace feedscope::ui
