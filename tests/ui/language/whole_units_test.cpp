#include "ui/language/whole_units.h"

#include <gtest/gtest.h>

#include <QFont>
#include <QTextLayout>

namespace feedscope::ui {
namespace {

TEST(WholeUnits, AreNotBrokenAtTheirSlash) {
  const QString text = with_whole_units(
      QStringLiteral("circles at 6 m/min, 9 m/min, jerk [m/s³], Kv in (m/min)/mm is 16.7 1/s"));
  for (int width = 40; width < 400; width += 7) {
    QTextLayout layout(text, QFont());
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      const QString words = text.mid(line.textStart(), line.textLength()).trimmed();
      if (line.naturalTextWidth() < width && line.textStart() + line.textLength() < text.size()) {
        EXPECT_FALSE(words.endsWith('/') || words.endsWith(QChar(0x2060))) << words.toStdString();
      }
    }
    layout.endLayout();
  }
}

TEST(WholeUnits, StayWithTheirNumber) {
  EXPECT_EQ(with_whole_units(QStringLiteral("A (0,002 mm), 46 % of 3 m/min, 12 s, 5 seconds, 2 may")),
            QString::fromUtf8(
                "A (0,002\u00a0mm), 46\u00a0% of 3\u00a0m\u2060/\u2060min, 12\u00a0s, 5 seconds, 2 may"));
  EXPECT_EQ(with_whole_units(QStringLiteral("it allows ____ m/min")),
            QString::fromUtf8("it allows ____\u00a0m\u2060/\u2060min"))
      << "a blank of a hand-out";
}

TEST(WholeUnits, LeaveOtherSlashesAlone) {
  for (const char* text : {"programs/part 5 m/other.nc", "a/mm/s", "base64,+m/s+1/s/", "<p>7/min</p>",
                           "5 </p>", "v² / R", "3 m/machine"}) {
    EXPECT_EQ(with_whole_units(QString::fromUtf8(text)), QString::fromUtf8(text));
  }
}

}  // namespace
}  // namespace feedscope::ui
