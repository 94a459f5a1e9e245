#include <gmock/gmock.h>

#include <QLocale>

#include "tests/ui/report/report_fixture.h"
#include "ui/language/language.h"
#include "ui/report/report_tables.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The messages of a program without feed and with an arc that is none, in a language.
std::string messages_in(const QString& language) {
  const LoadedProgram program =
      load_program(std::make_shared<const SourceText>("part.nc", "G21 G90\nG1 X10\nG2 X20\nX1..2\n"));
  ReportInput input;
  input.runs = report_runs({make_shown(simulate_run(program, make_setup({"", "cam", {}, {}})))});
  speak(language);
  const std::string block = messages_block(input).remove("<wbr>").toStdString();
  speak(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
  return block;
}

TEST(ReportMessages, SpeakTheLanguageOfTheReport) {
  EXPECT_THAT(messages_in(QStringLiteral("en")),
              AllOf(HasSubstr("a feed move without a feed"), HasSubstr("has no valid number")));
  EXPECT_THAT(messages_in(QStringLiteral("fr")),
              AllOf(HasSubstr("un déplacement en avance sans avance"), HasSubstr("programmez F avant"),
                    HasSubstr("n’a pas de nombre valable"), Not(HasSubstr("the ")), Not(HasSubstr(" is "))));
}

}  // namespace
}  // namespace feedscope::ui
