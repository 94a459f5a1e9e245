#include "ui/setup/setup_tables.h"
#include "ui/fields/choice_delegate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFont>
#include <QLocale>
#include <QSignalSpy>

#include "core/base/error.h"
#include "tests/ui/locale_in_force.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

Setup spinner() {
  SetupRequest request;
  request.machine = "spinner-mvc850";
  request.model = "essid";
  return make_setup(request);
}

class SetupTablesTest : public testing::Test {
 protected:
  SetupTablesTest() { QLocale::setDefault(QLocale::c()); }
  ~SetupTablesTest() override { QLocale::setDefault(QLocale::c()); }

  QModelIndex jerk_of_x() const {
    for (int row = 0; row < axes.rowCount(); ++row) {
      if (axis_limit_specs()[static_cast<std::size_t>(row)].key == "jerk") {
        return axes.index(row, 0);
      }
    }
    return {};
  }
  QModelIndex tolerance() const {
    return settings.index(settings.row_of("contour_tolerance_mm"), SettingsTable::value);
  }

  RunList runs{spinner()};
  SetupEdit edit{runs};
  AxisTable axes{edit, axis_limit_specs()};
  SettingsTable settings{edit};
};

TEST_F(SetupTablesTest, AreSoundItemModels) {
  QAbstractItemModelTester axes_tester(&axes, QAbstractItemModelTester::FailureReportingMode::Fatal);
  QAbstractItemModelTester settings_tester(&settings, QAbstractItemModelTester::FailureReportingMode::Fatal);
  edit.set("X.jerk", 20.0);
  edit.set_model(find_model("cam"));
  edit.set_file(spinner());
}

/// A field that is disabled when the model changes passes the focus to the table, which then draws cells.
TEST_F(SetupTablesTest, AnswerWhileOthersHearOfAChangeFirst) {
  RunList run_list(spinner());
  SetupEdit changed(run_list);
  std::vector<SetupTable*> tables;
  int asked = 0;
  QObject::connect(&changed, &SetupEdit::keys_changed, [&] {
    for (const SetupTable* table : tables) {
      for (int row = 0; row < table->rowCount(); ++row) {
        for (int column = 0; column < table->columnCount(); ++column) {
          asked += table->data(table->index(row, column)).isValid() ? 1 : 0;
          asked += table->data(table->index(row, column), Qt::ToolTipRole).isValid() ? 1 : 0;
        }
      }
    }
  });
  AxisTable of_axes(changed, axis_limit_specs());
  SettingsTable of_settings(changed);
  tables = {&of_axes, &of_settings};
  for (const char* model : {"grbl", "cam", "ward", "klipper"}) {
    asked = 0;
    EXPECT_NO_THROW(changed.set_model(find_model(model)));
    EXPECT_GT(asked, 10) << model;
  }
}

TEST_F(SetupTablesTest, ShowTheFile) {
  EXPECT_EQ(axes.data(jerk_of_x()).toString(), "15");
  EXPECT_EQ(axes.columnCount(), 3);
  EXPECT_THAT(axes.headerData(jerk_of_x().row(), Qt::Vertical, Qt::DisplayRole).toString().toStdString(),
              HasSubstr("m/s³"));
  EXPECT_EQ(settings.index(tolerance().row(), SettingsTable::unit).data().toString(), "mm");
}

TEST_F(SetupTablesTest, AnEditChangesTheSetupAndIsMarked) {
  ASSERT_TRUE(axes.setData(jerk_of_x(), "20"));
  EXPECT_DOUBLE_EQ(axis_limit(edit.setup().machine, 'X', "jerk"), 20);
  EXPECT_DOUBLE_EQ(edit.setup().machine.axes[0].jerk, 20000);
  EXPECT_TRUE(axes.data(jerk_of_x(), Qt::FontRole).value<QFont>().bold());
  EXPECT_THAT(axes.data(jerk_of_x(), Qt::ToolTipRole).toString().toStdString(),
              HasSubstr("machine file has 15"));
}

TEST_F(SetupTablesTest, APositionThatTheFileDoesNotGiveIsEmptyAndMayBeSetAndEmptied) {
  const QModelIndex home = settings.index(settings.row_of("home_z_mm"), SettingsTable::value);
  ASSERT_TRUE(home.isValid());
  EXPECT_EQ(settings.data(home).toString(), "");
  EXPECT_FALSE(settings.data(home, Qt::ToolTipRole).toString().isEmpty());
  ASSERT_TRUE(settings.setData(home, "-120,5"));
  EXPECT_EQ(edit.setup().settings.number("home_z_mm"), -120.5);
  EXPECT_FALSE(settings.setData(home, "above"));
  EXPECT_EQ(edit.setup().settings.number("home_z_mm"), -120.5);
  ASSERT_TRUE(settings.setData(home, ""));
  EXPECT_FALSE(edit.setup().settings.has("home_z_mm"));
  EXPECT_FALSE(settings.setData(tolerance(), "")) << "a model needs a tolerance";
}

TEST_F(SetupTablesTest, ASettingWithAUsualValueShowsItPaleUntilOneIsSet) {
  const int row = settings.row_of("feed_override_percent");
  const QModelIndex override = settings.index(row, SettingsTable::value);
  ASSERT_TRUE(override.isValid());
  EXPECT_FALSE(settings.is_unset(row)) << "it is not hidden among those that have none";
  EXPECT_EQ(settings.data(override).toString(), "100");
  EXPECT_TRUE(settings.data(override, Qt::ForegroundRole).isValid());
  EXPECT_EQ(settings.data(override, Qt::EditRole).toString(), "");
  ASSERT_TRUE(settings.setData(override, "120"));
  EXPECT_EQ(settings.data(override).toString(), "120");
  EXPECT_FALSE(settings.data(override, Qt::ForegroundRole).isValid());
  EXPECT_EQ(edit.setup().settings.number("feed_override_percent"), 120);
  ASSERT_TRUE(settings.setData(override, ""));
  EXPECT_FALSE(edit.setup().settings.has("feed_override_percent"));
}

TEST_F(SetupTablesTest, BackToTheFilesValueIsNoLongerMarked) {
  ASSERT_TRUE(axes.setData(jerk_of_x(), "20"));
  ASSERT_TRUE(axes.setData(jerk_of_x(), "15"));
  EXPECT_FALSE(axes.data(jerk_of_x(), Qt::FontRole).value<QFont>().bold());
}

TEST_F(SetupTablesTest, UndoAndRedoWalkThroughTheEdits) {
  QSignalSpy spy(&edit, &SetupEdit::values_changed);
  axes.setData(jerk_of_x(), "20");
  settings.setData(tolerance(), "0.05");
  edit.history().undo();
  edit.history().undo();
  EXPECT_EQ(axes.data(jerk_of_x()).toString(), "15");
  edit.history().redo();
  EXPECT_EQ(axes.data(jerk_of_x()).toString(), "20");
  EXPECT_EQ(spy.count(), 5);
}

TEST_F(SetupTablesTest, DecimalCommaIsReadAndShownInALocaleThatUsesIt) {
  const test::LocaleInForce locale{QLocale(QLocale::German)};
  ASSERT_TRUE(axes.setData(jerk_of_x(), "12,5"));
  EXPECT_DOUBLE_EQ(axis_limit(edit.setup().machine, 'X', "jerk"), 12.5);
  EXPECT_EQ(axes.data(jerk_of_x()).toString(), "12,5");
  ASSERT_TRUE(axes.setData(jerk_of_x(), "13.5"));
  EXPECT_EQ(axes.data(jerk_of_x()).toString(), "13,5");
}

TEST_F(SetupTablesTest, AWrongValueIsRefusedWithTheReason) {
  for (const char* wrong : {"-3", "0", "", "abc", "nan", "inf", "1,2,3"}) {
    QSignalSpy spy(&axes, &SetupTable::refused);
    EXPECT_FALSE(axes.setData(jerk_of_x(), wrong)) << wrong;
    ASSERT_EQ(spy.count(), 1) << wrong;
    EXPECT_THAT(spy.first().at(1).toString().toStdString(), HasSubstr("X Jerk")) << wrong;
    EXPECT_THAT(spy.first().at(1).toString().toStdString(), testing::Not(HasSubstr("s3"))) << wrong;
    EXPECT_EQ(axes.data(jerk_of_x()).toString(), "15") << wrong;
  }
  EXPECT_EQ(edit.history().count(), 0);
}

TEST_F(SetupTablesTest, OnlyValuesCanBeEdited) {
  const int row = tolerance().row();
  EXPECT_TRUE(settings.flags(tolerance()).testFlag(Qt::ItemIsEditable));
  EXPECT_FALSE(settings.flags(settings.index(row, SettingsTable::title)).testFlag(Qt::ItemIsEditable));
  EXPECT_FALSE(settings.setData(settings.index(row, SettingsTable::unit), "m"));
}

TEST_F(SetupTablesTest, ChoicesAreOfferedAndOthersRefused) {
  const QModelIndex reading = settings.index(settings.row_of("reading"), SettingsTable::value);
  ASSERT_TRUE(reading.isValid());
  EXPECT_TRUE(reading.data(ChoiceDelegate::choices_role).toStringList().contains("published"));
  EXPECT_TRUE(settings.setData(reading, "published"));
  EXPECT_FALSE(settings.setData(reading, "guessed"));
  EXPECT_EQ(reading.data().toString(), "published");
}

TEST_F(SetupTablesTest, AnotherModelKeepsTheEditsThatItReads) {
  edit.set("X.jerk", 20.0);
  edit.set("reading", std::string("strict"));
  edit.set_model(find_model("cam"));
  EXPECT_TRUE(edit.state().edited("X.jerk"));
  EXPECT_FALSE(edit.state().edited("reading"));
  EXPECT_EQ(settings.row_of("reading"), -1);
}

TEST_F(SetupTablesTest, EveryValueTellsItsSource) {
  EXPECT_THAT(axes.data(jerk_of_x(), Qt::ToolTipRole).toString().toStdString(),
              testing::AnyOf(HasSubstr("Source:"), HasSubstr("Assumed:")));
}

TEST_F(SetupTablesTest, WhatDiffersFromTheFileIsListedUntilItIsTakenBack) {
  edit.set("X.jerk", 20.0);
  edit.set("alpha", 3.0);
  EXPECT_EQ(changes_of(edit.state()), (QStringList{"X Jerk: 15 → 20 m/s³", "Tangent weight alpha: 2.5 → 3"}));
  edit.reset();
  EXPECT_TRUE(changes_of(edit.state()).isEmpty());
  edit.history().undo();
  EXPECT_EQ(changes_of(edit.state()).size(), 2);
}

TEST_F(SetupTablesTest, AnUnknownKeyIsAnError) {
  EXPECT_THROW(edit.set("X.haste", 1.0), InputError);
}

TEST_F(SetupTablesTest, ShowAndTakeInchesAndKeepTheUnitOfTheKey) {
  use_unit_system(UnitSystem::inch);
  EXPECT_EQ(axes.data(jerk_of_x()).toString(), "590.55");
  EXPECT_TRUE(axes.setData(jerk_of_x(), "1000"));
  EXPECT_NEAR(std::get<double>(edit.state().value("X.jerk")), 25.4, 1e-9);
  EXPECT_TRUE(settings.setData(tolerance(), "0.002"));
  EXPECT_NEAR(std::get<double>(edit.state().value("contour_tolerance_mm")), 0.0508, 1e-12);
  EXPECT_TRUE(axes.setData(jerk_of_x(), axes.data(jerk_of_x())));
  EXPECT_NEAR(std::get<double>(edit.state().value("X.jerk")), 25.4, 1e-9)
      << "its rounded text changes nothing";
  use_unit_system(UnitSystem::metric);
}

}  // namespace
}  // namespace feedscope::ui
