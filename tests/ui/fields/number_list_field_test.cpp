#include "ui/fields/number_list_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLocale>

namespace feedscope::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(NumberListField, BlanksAndSemicolonsSeparateNumbersWithEitherDecimalSign) {
  QLocale::setDefault(QLocale::c());
  NumberListField field;
  field.setText(" 2.5;30  0,02 ");
  EXPECT_THAT(field.numbers(), ElementsAre(2.5, 30, 0.02));
  EXPECT_TRUE(field.problem().isEmpty());
}

TEST(NumberListField, NumbersComeBackInEveryLanguage) {
  for (const char* language : {"en", "fr", "de"}) {
    QLocale::setDefault(QLocale(language));
    NumberListField field;
    field.set_numbers({6000, 0.125});
    EXPECT_THAT(field.numbers(), ElementsAre(6000, 0.125)) << language;
  }
  QLocale::setDefault(QLocale::c());
}

TEST(NumberListField, OneWrongNumberIsNamed) {
  QLocale::setDefault(QLocale::c());
  NumberListField field;
  field.setText("30 x");
  EXPECT_TRUE(field.numbers().empty());
  EXPECT_THAT(field.problem().toStdString(), HasSubstr("“x” is not a number"));
  field.setText("");
  EXPECT_THAT(field.problem().toStdString(), HasSubstr("Type one number or several"));
}

}  // namespace
}  // namespace feedscope::ui
