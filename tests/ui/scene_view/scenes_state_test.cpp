#include "ui/scene_view/scenes_state.h"

#include <gtest/gtest.h>

#include <QJsonObject>

namespace feedscope::ui {
namespace {

TEST(ScenesState, SurvivesJsonAndKeepsWhatIsMissingOrWrong) {
  const ScenesState state{ScenesMode::split, 2, 0.3, 1};
  ScenesState read;
  read_json(to_json(state), read);
  EXPECT_EQ(read, state);
  read_json({}, read);
  EXPECT_EQ(read, state);
  read_json({{"mode", "four"}, {"split", 1.5}, {"other_run", -1}, {"reference_run", 0.5}}, read);
  EXPECT_EQ(read, state);
  ScenesState plain;
  read_json(to_json(ScenesState()), plain);
  EXPECT_EQ(plain, ScenesState());
}

}  // namespace
}  // namespace feedscope::ui
