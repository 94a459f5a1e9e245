#include "ui/annotations/annotation_text.h"

#include <gtest/gtest.h>

#include <QLocale>

#include "tests/ui/locale_in_force.h"

namespace feedscope::ui {
namespace {

AnnotationValues some_values() {
  AnnotationValues values;
  values.at.speed = 100;  // 6000 mm/min
  values.at.line = 1200;
  values.at.position = Vec3(1.5, -2, 0);
  values.at.acceleration = Vec3(0, 3000, 4000);
  values.at.cause = {CauseKind::axis_jerk, 0};
  values.contour_error = 0.0082;
  values.distance = 12.3456;
  values.duration = 0.25;
  values.run = "essid {feed}";
  return values;
}

class AnnotationText : public testing::Test {
 protected:
  AnnotationText() { QLocale::setDefault(QLocale::c()); }
};

TEST_F(AnnotationText, NamesInBracesBecomeValuesWithUnits) {
  EXPECT_EQ(with_values("{feed}, {deviation}", some_values()), QStringLiteral("6000 mm/min, 8.2 µm"));
  EXPECT_EQ(with_values("{cause}\nline {line}", some_values()), QStringLiteral("jerk of axis X\nline 1200"));
  EXPECT_EQ(with_values("{acceleration} {distance} {duration} {x}", some_values()),
            QStringLiteral("5.00 m/s² 12.346 mm 0.250 s 1.500 mm"));
}

TEST_F(AnnotationText, EveryFieldHasAValue) {
  for (const AnnotationField& field : annotation_fields()) {
    const QString name = QStringLiteral("{%1}").arg(field.name);
    EXPECT_NE(with_values(name, some_values()), name) << field.name.toStdString();
    EXPECT_EQ(unknown_field(name), QString()) << field.name.toStdString();
  }
}

TEST_F(AnnotationText, TellsOfTheDrivesWhereThereAreAny) {
  AnnotationValues values = some_values();
  EXPECT_EQ(with_values("{actual_contour_error}", values), QStringLiteral("–"));
  values.actual.emplace();
  values.actual->contour_error = 0.0125;
  EXPECT_EQ(with_values("{actual_contour_error}", values), QStringLiteral("12.5 µm"));
}

TEST_F(AnnotationText, WhatIsNoFieldStaysAndIsNamed) {
  EXPECT_EQ(with_values("{fed} {} {Feed} {", some_values()), QStringLiteral("{fed} {} {Feed} {"));
  EXPECT_EQ(unknown_field("{feed} and {fed} and {fet}"), QStringLiteral("{fed}"));
}

TEST_F(AnnotationText, AValueIsNotReadAgain) {
  EXPECT_EQ(with_values("{run}", some_values()), QStringLiteral("essid {feed}"));
}

TEST_F(AnnotationText, NumbersFollowTheLocale) {
  const test::LocaleInForce locale{QLocale(QLocale::German)};
  EXPECT_EQ(with_values("{deviation}", some_values()), QStringLiteral("8,2 µm"));
}

TEST_F(AnnotationText, WhatANewAnnotationSaysHasNoUnknownField) {
  for (const AnnotationKind kind : annotation_kinds) {
    EXPECT_EQ(unknown_field(first_text(kind)), QString());
    EXPECT_NE(with_values(first_text(kind), some_values()), first_text(kind));
  }
}

}  // namespace
}  // namespace feedscope::ui
