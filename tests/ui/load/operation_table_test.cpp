#include "ui/load/operation_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>
#include <QSignalSpy>

#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "ui/fields/choice_delegate.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class OperationTableTest : public testing::Test {
 protected:
  OperationTableTest() {
    QLocale::setDefault(QLocale::c());
    table.set_program(program.program);
    QObject::connect(&table, &OperationTable::refused,
                     [this](const QString& message) { refusal = message.toStdString(); });
  }
  ~OperationTableTest() override {
    QLocale::setDefault(QLocale::c());
    use_unit_system(UnitSystem::metric);
  }

  int column(const QString& title) const {
    for (int i = 0; i < table.columnCount(); ++i) {
      if (table.headerData(i, Qt::Horizontal, Qt::DisplayRole).toString().startsWith(title)) {
        return i;
      }
    }
    return -1;
  }
  bool type(const QString& title, const QString& text) {
    return table.setData(table.index(0, column(title)), text);
  }
  const Engagement& operation() const { return table.setup().operations.front(); }

  LoadedProgram program = load_program(std::make_shared<const SourceText>(
      "part.nc", "G21\nT5 M6\nS8000 M3\nG1 X10 F600\nT7 M6\nG1 X20\nM30\n"));
  OperationTable table;
  std::string refusal;
};

TEST_F(OperationTableTest, IsAModel) {
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  table.add();
  table.add();
  table.remove(0);
  EXPECT_EQ(table.rowCount(), 1);
}

TEST_F(OperationTableTest, ANewOperationIsOfTheFirstToolThatHasNone) {
  table.add();
  table.add();
  table.add();
  EXPECT_EQ(table.setup().operations[0].tool, "5");
  EXPECT_EQ(table.setup().operations[1].tool, "7");
  EXPECT_EQ(table.setup().operations[2].tool, "");
  EXPECT_EQ(operation_problem(operation()), "");
}

TEST_F(OperationTableTest, NumbersAreReadInTheUnitShown) {
  table.add();
  QSignalSpy edited(&table, &OperationTable::edited);
  EXPECT_TRUE(type("Diameter", "12"));
  EXPECT_TRUE(type("Helix", "45"));
  EXPECT_TRUE(type("Spindle", "6000"));
  EXPECT_TRUE(type("Least chip", "20"));
  EXPECT_TRUE(type("Max. torque", "1.5"));
  EXPECT_EQ(edited.size(), 5);
  EXPECT_DOUBLE_EQ(operation().diameter, 12);
  EXPECT_DOUBLE_EQ(operation().helix, units::pi / 4);
  EXPECT_DOUBLE_EQ(operation().spindle_speed.value(), 100);
  EXPECT_DOUBLE_EQ(operation().least_chip.value(), 0.02);
  EXPECT_DOUBLE_EQ(operation().max_torque.value(), 1500);
  EXPECT_TRUE(type("Least chip", ""));
  EXPECT_FALSE(operation().least_chip.has_value());
}

TEST_F(OperationTableTest, NumbersOfOtherLanguagesAndUnits) {
  QLocale::setDefault(QLocale(QLocale::French));
  table.add();
  EXPECT_TRUE(type("Diameter", "12,7"));
  EXPECT_DOUBLE_EQ(operation().diameter, 12.7);
  use_unit_system(UnitSystem::inch);
  EXPECT_EQ(table.data(table.index(0, column("Diameter"))).toString(), "0,5");
  EXPECT_TRUE(type("Axial depth", "0,25"));
  EXPECT_DOUBLE_EQ(operation().axial_depth, 6.35);
}

TEST_F(OperationTableTest, WhatIsWrongIsRefusedWithTheReason) {
  table.add();
  const Engagement before = operation();
  const std::vector<std::tuple<const char*, const char*, const char*>> wrong{
      {"Diameter", "0", "must be above 0 and at most 2000"},
      {"Diameter", "wide", "wide"},
      {"Diameter", "", "Diameter"},
      {"Teeth", "2.5", "whole number"},
      {"Helix", "81", "must be from 0 to 80"},
      {"Lines", "20-", "must be ranges of lines"},
      {"Max. power", "-1", "must be above 0"}};
  for (const auto& [title, text, reason] : wrong) {
    refusal.clear();
    EXPECT_FALSE(type(title, text)) << title << ' ' << text;
    EXPECT_THAT(refusal, HasSubstr(reason)) << title << ' ' << text;
    EXPECT_EQ(operation(), before) << title << ' ' << text;
  }
}

TEST_F(OperationTableTest, ChoicesAreThoseOfTheProgramAndOfTheMaterials) {
  table.add();
  const auto choices = [this](int at) {
    return table.data(table.index(0, at), ChoiceDelegate::choices_role).toStringList();
  };
  EXPECT_EQ(choices(OperationTable::tool), QStringList({"5", "7", "all tools"}));
  EXPECT_TRUE(choices(OperationTable::material).contains("Steel C45 (1.0503, AISI 1045), normalised"));
  EXPECT_TRUE(choices(OperationTable::first_number).isEmpty());
  EXPECT_TRUE(type("Tool", "all tools"));
  EXPECT_EQ(operation().tool, "");
  EXPECT_TRUE(type("Material", "Steel C45 (1.0503, AISI 1045), normalised"));
  EXPECT_EQ(operation().material, "steel-c45");
  EXPECT_TRUE(type("Milling", "up (conventional)"));
  EXPECT_EQ(operation().milling, Milling::up);
  EXPECT_TRUE(type("Lines", "4-6, 9"));
  EXPECT_EQ(operation().lines, (std::vector<ProgramLines>{{4, 6}, {9, 9}}));
}

TEST_F(OperationTableTest, AMaterialOfOnesOwnCanBeChosen) {
  LoadSetup setup;
  Material own;
  own.id = "mine";
  own.title = "My alloy";
  own.cutting = {700, 200, 100};
  setup.materials = {own};
  table.set_setup(setup);
  table.add();
  EXPECT_TRUE(type("Material", "My alloy"));
  EXPECT_EQ(operation().material, "mine");
}

}  // namespace
}  // namespace feedscope::ui
