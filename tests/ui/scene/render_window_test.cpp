#include "ui/scene/render_window.h"

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <stdexcept>

namespace feedscope::ui {
namespace {

TEST(RenderWindow, DrawsInSoftwareWithoutADisplay) {
  const auto window = make_render_window(RenderBackend::software);
  window->SetSize(64, 64);
  window->Render();
  EXPECT_TRUE(window->IsCurrent());
  window->ReleaseCurrent();
  EXPECT_FALSE(window->IsCurrent());
}

TEST(RenderWindow, RefusesTheOtherKindInOneProcess) {
  const auto window = make_render_window(RenderBackend::software);
  EXPECT_THROW(make_render_window(RenderBackend::gpu), std::logic_error);
}

TEST(RenderWindow, SeveralOfAKindTakeTurns) {
  const auto first = make_render_window(RenderBackend::software);
  const auto second = make_render_window(RenderBackend::software);
  for (const auto& window : {first, second, first}) {
    window->SetSize(80, 60);
    window->Render();
    EXPECT_TRUE(window->IsCurrent());
  }
  EXPECT_FALSE(second->IsCurrent());
}

}  // namespace
}  // namespace feedscope::ui
