#include "ui/paper/text_outline.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace feedscope::ui {
namespace {

constexpr int window_height = 600;
constexpr double from_left = 100;
constexpr double from_top = 400;

TextOutline outline_of(const char* text, double turned = 0) {
  const vtkNew<vtkTextActor> actor;
  actor->SetInput(text);
  actor->SetPosition(from_left, window_height - from_top);
  actor->GetTextProperty()->SetFontFamilyToArial();
  actor->GetTextProperty()->SetFontSize(40);
  actor->GetTextProperty()->SetOrientation(turned);
  return text_outline(*actor, window_height);
}

double width_of(const char* text) {
  return outline_of(text).shape.boundingRect().width();
}

/// Those of micrometres, of French, and of settings that change; the arrow is in no font of VTK.
TEST(TextOutline, HasLettersBeyondAscii) {
  EXPECT_GT(width_of("µm"), 1.3 * width_of("m")) << "a micrometre is no metre";
  for (const char* text : {"µ", "é", "²", "−", "×", "°", "Ø", "œ", "→"}) {
    EXPECT_FALSE(outline_of(text).shape.isEmpty()) << text;
  }
  EXPECT_GT(width_of("5 → 7"), width_of("5  7"));
}

TEST(TextOutline, HasItsLettersWhereItsShapeIs) {
  for (const char* text : {"12.5 µm", "programmée", "5 → 7"}) {
    for (const double turned : {0.0, 30.0}) {
      const TextOutline outline = outline_of(text, turned);
      QPainterPath letters;
      letters.addText({}, outline.font, outline.text);
      const QRectF there = outline.place.map(letters).boundingRect();
      const QRectF shape = outline.shape.boundingRect();
      EXPECT_LT((there.center() - shape.center()).manhattanLength(), 8) << text << " turned " << turned;
      EXPECT_NEAR(there.width(), shape.width(), 12) << text << " turned " << turned;
    }
  }
}

TEST(TextOutline, IsEmptyWithoutLetters) {
  EXPECT_TRUE(outline_of("").shape.isEmpty());
  EXPECT_TRUE(outline_of("  ").shape.isEmpty());
}

}  // namespace
}  // namespace feedscope::ui
