#include "ui/film/frame_pattern.h"

#include <gmock/gmock.h>

#include "core/base/error.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(FramePattern, NumbersTheFilesAsPrintfDoes) {
  EXPECT_EQ(FramePattern("frames/%05d.png").file(7), "frames/00007.png");
  EXPECT_EQ(FramePattern("%d.png").file(1234), "1234.png");
  EXPECT_EQ(FramePattern("/a/part-%02d-.png").file(123), "/a/part-123-.png");
  EXPECT_EQ(FramePattern("%3d.png").file(7), "  7.png");
}

TEST(FramePattern, RefusesWhatIsNoneAndShowsOne) {
  for (const auto& [pattern, message] :
       {std::pair("frame.png", "needs a number"), std::pair("f%05d/frame.png", "not in that of a folder"),
        std::pair("%d-%d.png", "two numbers"), std::pair("%s.png", "followed by d"),
        std::pair("%", "followed by d"), std::pair("%5", "followed by d"),
        std::pair("%99999999999999999999d.png", "up to 20"), std::pair("%n.png", "followed by d")}) {
    EXPECT_THAT([pattern = pattern] { FramePattern{pattern}; },
                ThrowsMessage<InputError>(testing::AllOf(HasSubstr(message), HasSubstr("frames/%05d.png"))))
        << pattern;
  }
}

}  // namespace
}  // namespace feedscope::ui
