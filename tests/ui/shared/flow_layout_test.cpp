#include "ui/shared/flow_layout.h"

#include <gtest/gtest.h>

#include <QWidget>
#include <memory>

namespace feedscope::ui {
namespace {

class Box : public QWidget {
 public:
  using QWidget::QWidget;
  QSize sizeHint() const override { return {100, 20}; }
};

TEST(FlowLayout, PutsInARowWhatFitsAndTheRestBelow) {
  QWidget window;
  auto* flow = new FlowLayout(&window);
  flow->setContentsMargins(0, 0, 0, 0);
  flow->setSpacing(4);
  std::array<Box*, 3> boxes{};
  for (Box*& box : boxes) {
    box = new Box(&window);
    flow->addWidget(box);
  }
  EXPECT_EQ(flow->sizeHint(), QSize(308, 20)) << "all in one row";
  EXPECT_EQ(flow->heightForWidth(308), 20);
  EXPECT_EQ(flow->heightForWidth(307), 44) << "one pixel less";
  EXPECT_EQ(flow->heightForWidth(100), 68);
  flow->setGeometry({10, 5, 210, 60});
  EXPECT_EQ(boxes[1]->geometry(), QRect(114, 5, 100, 20));
  EXPECT_EQ(boxes[2]->geometry(), QRect(10, 29, 100, 20));
  boxes[1]->setVisible(false);
  EXPECT_EQ(flow->heightForWidth(204), 20) << "what is hidden takes no room";
}

}  // namespace
}  // namespace feedscope::ui
