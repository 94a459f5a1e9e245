#include "ui/scene_view/scene_json.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>

namespace feedscope::ui {
namespace {

SceneState changed() {
  return {{Vec3(1, -2.5, 0.125), 0.3, -0.7, 12.5, true, true},
          Colouring::contour_error,
          50,
          {ToolKind::bull, 6.125, 0.8},
          false,
          true,
          false};
}

TEST(SceneJson, ComesBackAsItWas) {
  const QByteArray text = QJsonDocument(to_json(changed())).toJson();
  SceneState read;
  read_json(QJsonDocument::fromJson(text).object(), read);
  EXPECT_EQ(read, changed());
}

TEST(SceneJson, EveryColouringAndToolComesBack) {
  for (const Colouring colouring : all_colourings()) {
    for (const ToolKind kind :
         {ToolKind::none, ToolKind::marker, ToolKind::flat, ToolKind::ball, ToolKind::bull}) {
      const SceneState state{.colouring = colouring, .tool = {.kind = kind}};
      SceneState read = changed();
      read_json(to_json(state), read);
      EXPECT_EQ(read, state);
    }
  }
}

TEST(SceneJson, WrongJsonChangesNothing) {
  SceneState state = changed();
  read_json({}, state);
  read_json({{"camera", QJsonObject{{"focal_mm", QJsonArray{1, 2}}, {"height_mm", -1}, {"azimuth_rad", "n"}}},
             {"colouring", "rainbow"},
             {"exaggeration", 0},
             {"tool", QJsonObject{{"kind", "saw"}, {"diameter_mm", 0}}},
             {"grid", 1}},
            state);
  EXPECT_EQ(state, changed());
}

TEST(SceneState, AnyPathIsFittedInTheSameDirection) {
  const SceneState any = for_any_path(changed());
  EXPECT_TRUE(any.camera.fitted);
  EXPECT_EQ(any.camera.azimuth, changed().camera.azimuth);
  EXPECT_EQ(any.camera.elevation, changed().camera.elevation);
  EXPECT_TRUE(any.camera.perspective);
  EXPECT_EQ(any.camera.focal, CameraState().focal);
  EXPECT_EQ(any.colouring, Colouring::contour_error);
}

}  // namespace
}  // namespace feedscope::ui
