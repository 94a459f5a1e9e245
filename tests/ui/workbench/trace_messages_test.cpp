#include "ui/workbench/trace_messages.h"

#include <gtest/gtest.h>

namespace feedscope::ui {
namespace {

TEST(TraceMessages, NameNoOptionOfTheCommandLine) {
  const std::pair<const char*, const char*> texts[] = {
      {"give its columns the unit, as --columns x=2:in, where that is right",
       "give its columns the unit (options), where that is right"},
      {"name the columns of the others alone, as --columns time=1,x=2: times can be compared then",
       "name the columns of the others alone (options): times can be compared then"},
      {"say what they are: --columns time=1:s,x=2:mm,y=3:mm,z=4:mm", "say what they are (options)"},
      {"say the rate in samples a second: --columns linuxcnc, or ...,rate=1000",
       "say the rate in samples a second (options)"},
      {"nommez leurs colonnes, comme --columns x=2:mm,y=3:mm", "nommez leurs colonnes (options)"},
      {"ne nommer que les colonnes des autres, comme --columns time=1,x=2 : les temps peuvent être comparés",
       "ne nommer que les colonnes des autres (options) : les temps peuvent être comparés"},
      {"l’indiquer : --columns time=1:ms", "l’indiquer (options)"},
      {"record the time with more digits", "record the time with more digits"}};
  for (const auto& [text, said] : texts) {
    EXPECT_EQ(without_columns_option(QString::fromUtf8(text), " (options)").toStdString(), said);
  }
}

TEST(TraceMessages, SendToTheDialogOfTheWindow) {
  Diagnostic message;
  message.message = Message::as_written("axis X of the trace is mirrored; it is used with the other sign");
  message.hint =
      Message::as_written("give its column a minus sign, as --columns x=2:-mm, where that is right");
  EXPECT_EQ(message_text(message).toStdString(),
            "Axis X of the trace is mirrored; it is used with the other sign. Give its column a minus sign "
            "(Trace import options), where that is right.");
}

}  // namespace
}  // namespace feedscope::ui
