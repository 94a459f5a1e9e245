#include "ui/identification/identification_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>
#include <fstream>
#include <sstream>

#include "core/analysis/time/line_times.h"
#include "core/drives/drive_response.h"
#include "tests/support/folders.h"
#include "tests/ui/patience.h"
#include "tests/ui/trace_fixture.h"
#include "ui/identification/fit_choice.h"
#include "ui/identification/recordings_box.h"
#include "ui/identification/residual_chart.h"
#include "ui/identification/result_box.h"
#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* moves =
    "G21 G90\nG1 X30 F6000\nG4 P0.1\nX0\nG4 P0.1\nY30\nG4 P0.1\nX20 Y0\nG4 P0.1\nX0\nM30\n";

feedscope::Run run_of(const std::vector<std::string>& settings, const char* text = moves) {
  SetupRequest request;
  request.machine = "linuxcnc-mill";
  request.assignments = settings;
  return simulate_run(load_program(std::make_shared<const SourceText>("moves.nc", text)),
                      make_setup(request));
}

class IdentificationViewTest : public testing::Test {
 protected:
  IdentificationViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(370, 900);
    view.show();
  }
  bool wait() {
    return QTest::qWaitFor([this] { return !model.busy() && !model.traces().busy() && !view.busy(); },
                           patience);
  }
  void open_trace(const std::string& text) {
    model.traces().add(files.write("scope.csv", text));
    ASSERT_TRUE(wait());
  }
  void look_for(const std::vector<std::string>& keys) {
    view.choice().tick_none();
    QTreeWidget& list = view.choice().parameters();
    for (int row = 0; row < list.topLevelItemCount(); ++row) {
      QTreeWidgetItem* item = list.topLevelItem(row);
      if (std::ranges::find(keys, item->data(0, Qt::UserRole).toString().toStdString()) != keys.end()) {
        item->setCheckState(0, Qt::Checked);
      }
    }
    QCoreApplication::processEvents();
  }
  void tick_model(const QString& id, bool on = true) {
    QListWidget& list = view.choice().models();
    for (int row = 0; row < list.count(); ++row) {
      if (list.item(row)->data(Qt::UserRole).toString() == id) {
        list.item(row)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
      }
    }
  }
  QString found(int row, int column = 2) {
    return view.result().parameters().topLevelItem(row)->text(column);
  }

  const feedscope::Run start = run_of({});
  const feedscope::Run truth = run_of({"X.acceleration=1.3", "Y.acceleration=0.6"});
  const test::WrittenFiles files;
  Workbench model{shipped_machines(), start.setup};
  IdentificationView view{model};
};

TEST_F(IdentificationViewTest, SaysStepByStepWhatIsMissing) {
  EXPECT_FALSE(view.identify_button().isEnabled());
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Open the program"));
  EXPECT_THAT(view.recordings().note().toStdString(), HasSubstr("run the test program"));
  model.show(start);
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Step 1"));
  EXPECT_THAT(view.recordings().note().toStdString(), HasSubstr("Record X, Y and Z"));
  open_trace(test::trace_table(truth));
  EXPECT_TRUE(view.identify_button().isEnabled()) << view.message().toStdString();
  tick_model("linuxcnc", false);
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Step 2: tick a control model"));
  tick_model("linuxcnc");
  view.choice().tick_none();
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Step 2: tick a number"));
  EXPECT_FALSE(view.identify_button().isEnabled());
  view.identify();
  EXPECT_FALSE(view.busy());
}

TEST_F(IdentificationViewTest, FindsTheMachineThatATraceWasRecordedOn) {
  model.show(start);
  open_trace(test::trace_table(truth));
  look_for({"X.acceleration", "Y.acceleration", "Z.acceleration"});
  view.identify_button().click();
  EXPECT_TRUE(view.busy());
  ASSERT_TRUE(wait());
  ASSERT_NE(view.result().chosen(), nullptr) << view.message().toStdString();
  EXPECT_THAT(view.result().verdict().toStdString(), HasSubstr("explains what was recorded"));
  EXPECT_THAT(view.result().verdict().toStdString(), HasSubstr("scope.csv: "));
  ASSERT_EQ(view.result().parameters().topLevelItemCount(), 3);
  EXPECT_EQ(found(0, 0), "X Acceleration [m/s²]");
  EXPECT_EQ(found(0, 1), "0.75");
  EXPECT_NEAR(found(0).section(' ', 0, 0).toDouble(), 1.3, 0.013) << found(0).toStdString();
  EXPECT_THAT(found(0).toStdString(), HasSubstr(" ± "));
  EXPECT_EQ(found(2), "not found");
  view.result().parameters().setCurrentItem(view.result().parameters().topLevelItem(2));
  EXPECT_THAT(view.result().explanation().toStdString(), HasSubstr("part SINGLE MOVES OF Z"));
}

/// What a control with drives records: set and actual position of X.
std::string table_with_drive(const feedscope::Run& run) {
  const DriveResponse response(run.trajectory, run.setup.machine);
  ActualWalk walk(response);
  std::string text = "time [s],x set [mm],y [mm],x actual [mm]\n";
  const MotionRecord record = record_of(*run.trajectory, 2e-3);
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const Vec3& place = record.place[i];
    text += fmt::format("{:.6f},{:.5f},{:.5f},{:.5f}\n", record.time[i], place.x(), place.y(),
                        walk.at(record.time[i]).position.x());
  }
  return text;
}

TEST_F(IdentificationViewTest, OffersTheDrivesWhosePositionsAreRecorded) {
  model.show(start);
  const auto offered = [&] {
    QStringList titles;
    for (int row = 0; row < view.choice().parameters().topLevelItemCount(); ++row) {
      titles.append(view.choice().parameters().topLevelItem(row)->text(0));
    }
    return titles.join('\n').toStdString();
  };
  EXPECT_THAT(offered(), Not(HasSubstr("Kv")));
  open_trace(table_with_drive(run_of({"X.acceleration=1.3", "X.kv=40", "X.velocity_lag=5"})));
  EXPECT_THAT(offered(), HasSubstr("X Position gain Kv"));
  EXPECT_THAT(offered(), Not(HasSubstr("Y Position gain Kv")));
  look_for({"X.acceleration", "X.kv"});
  view.identify();
  ASSERT_TRUE(wait());
  ASSERT_NE(view.result().chosen(), nullptr) << view.message().toStdString();
  ASSERT_EQ(view.result().parameters().topLevelItemCount(), 4);
  EXPECT_EQ(found(1, 0), "X Position gain Kv [1/s]");
  EXPECT_EQ(found(1, 1), "–");
  EXPECT_NEAR(found(1).section(' ', 0, 0).toDouble(), 40, 0.4) << found(1).toStdString();
  EXPECT_NEAR(found(2).section(' ', 0, 0).toDouble(), 0, 0.05)
      << "there is no feed-forward, or it is not told";
  EXPECT_NEAR(found(3).section(' ', 0, 0).toDouble(), 5, 0.1) << found(3).toStdString();
  EXPECT_THAT(view.result().verdict().toStdString(), HasSubstr("Drive of X: following error"));
}

TEST_F(IdentificationViewTest, WhatWasFoundBecomesARunAndAMachineFile) {
  model.show(start);
  open_trace(test::trace_table(truth));
  look_for({"X.acceleration", "Y.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  view.show_as_run();
  ASSERT_TRUE(wait());
  ASSERT_EQ(model.runs().items().size(), 2U);
  EXPECT_EQ(model.runs().current(), 1U);
  EXPECT_EQ(model.runs().current_item().name, "Identified from scope.csv");
  EXPECT_NEAR(std::get<double>(model.setup().state().value("X.acceleration")), 1.3, 0.013);
  ASSERT_NE(model.traces().result(0), nullptr);
  EXPECT_LT(std::abs(model.traces().result(0)->agreement.time_error()), 1e-3);
  EXPECT_TRUE(view.result().parameters().isEnabled()) << "begun with the same run still";
  EXPECT_EQ(model.setup().file().machine.name, "Retrofitted mill, identified");
  const std::filesystem::path file = files.write("mine.toml", "");
  view.save_machine(file);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("identified from"));
  EXPECT_THAT(text.str(), HasSubstr("mine"));
  EXPECT_NEAR(shipped_machines().load(file.string()).axes[0].acceleration, 1300, 13);
  model.runs().history().undo();
  EXPECT_EQ(model.runs().items().size(), 1U) << "the run with its name is one step";
}

TEST_F(IdentificationViewTest, AResultIsMarkedWhereWhatItIsOfHasChanged) {
  model.show(start);
  open_trace(test::trace_table(truth));
  look_for({"X.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  EXPECT_TRUE(view.result().parameters().isEnabled());
  model.setup().set("Y.acceleration", 0.5);
  EXPECT_FALSE(view.result().parameters().isEnabled()) << "it begins with another machine";
  model.setup().set("Y.acceleration", 0.75);
  EXPECT_TRUE(view.result().parameters().isEnabled());
  view.recordings().list().item(0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(view.result().parameters().isEnabled());
}

TEST_F(IdentificationViewTest, ComparesModelsByHowWellTheyExplain) {
  model.show(start);
  open_trace(test::trace_table(truth));
  tick_model("cam");
  look_for({"X.acceleration", "Y.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  QTreeWidget& models = view.result().models();
  ASSERT_EQ(models.topLevelItemCount(), 2) << view.message().toStdString();
  EXPECT_THAT(models.topLevelItem(0)->text(0).toStdString(), HasSubstr("LinuxCNC"));
  EXPECT_EQ(models.topLevelItem(0)->text(3), "yes");
  EXPECT_EQ(models.topLevelItem(1)->text(3), "no");
  view.result().choose(1);
  EXPECT_THAT(view.result().verdict().toStdString(), HasSubstr("does not explain"));
  EXPECT_EQ(found(0), "not found");
}

TEST_F(IdentificationViewTest, TakesTimesOfSectionsInsteadOfATrace) {
  model.show(start);
  const LineTimes times(*truth.trajectory);
  std::string table = "section,seconds\n";
  for (std::uint32_t line = 2; line <= 10; line += 2) {
    table += fmt::format("{}-{},{:.4f}\n", line, line, times.of(line, line).time);
  }
  view.add_table(files.write("times.csv", table));
  EXPECT_EQ(view.recordings().list().count(), 1);
  look_for({"X.acceleration", "Y.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  ASSERT_NE(view.result().chosen(), nullptr) << view.message().toStdString();
  EXPECT_NEAR(found(0).section(' ', 0, 0).toDouble(), 1.3, 0.026) << found(0).toStdString();
  view.add_table(files.write("few.csv", "section,seconds\n1,2\n"));
  EXPECT_THAT(view.message().toStdString(), HasSubstr("at least 4"));
  EXPECT_EQ(view.recordings().list().count(), 1);
}

TEST_F(IdentificationViewTest, AnotherPanelShowsWhatWasChosenAndFound) {
  model.show(start);
  open_trace(test::trace_table(truth));
  view.add_table(files.write("times.csv", "section,seconds\n2-2,1\n4-4,1\n6-6,1\n8-8,1.5\n"));
  view.recordings().list().item(1)->setCheckState(Qt::Unchecked);
  tick_model("cam");
  look_for({"X.acceleration", "Y.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  view.result().choose(1);
  IdentificationView other(model);
  other.set_state(view.state());
  ASSERT_NE(other.result().chosen(), nullptr);
  EXPECT_EQ(other.result().verdict(), view.result().verdict()) << "of the model that was chosen";
  EXPECT_EQ(other.result().parameters().topLevelItem(0)->text(2), found(0));
  EXPECT_TRUE(other.result().parameters().isEnabled());
  EXPECT_EQ(other.choice().starts(), view.choice().starts());
  EXPECT_EQ(other.recordings().list().count(), 2);
  EXPECT_EQ(other.recordings().list().item(1)->text(), "times.csv: 4 section times");
  EXPECT_EQ(other.recordings().list().item(1)->checkState(), Qt::Unchecked);
  other.recordings().list().item(1)->setCheckState(Qt::Checked);
  EXPECT_FALSE(other.result().parameters().isEnabled()) << "it was found without the table";
}

/// As a session gives it back: before the trace has been read.
TEST_F(IdentificationViewTest, AKeptResultIsUpToDateIfItsRecordingIsStillTheSame) {
  model.show(start);
  open_trace(test::trace_table(truth));
  look_for({"X.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  const IdentificationState kept = view.state();
  EXPECT_FALSE(kept.result.stale);
  for (const bool same : {true, false}) {
    Workbench later{shipped_machines(), start.setup};
    later.show(start);
    const feedscope::Run other = run_of({"X.acceleration=1.2"});
    later.traces().add(files.write("scope.csv", test::trace_table(same ? truth : other)));
    IdentificationView panel(later);
    panel.set_state(kept);
    EXPECT_TRUE(panel.result().parameters().isEnabled()) << "it is not known yet that it is another one";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !later.traces().busy(); }, patience));
    EXPECT_EQ(panel.result().parameters().isEnabled(), same);
    EXPECT_EQ(panel.state().result.stale, !same);
    panel.set_state(panel.state());
    EXPECT_EQ(panel.result().parameters().isEnabled(), same) << "out of date stays out of date";
    later.setup().set("X.acceleration", 0.5);
    EXPECT_FALSE(panel.result().parameters().isEnabled()) << "it begins with another machine";
  }
}

TEST_F(IdentificationViewTest, DrawsWhatIsLeftOverOfEachRecording) {
  EXPECT_TRUE(view.result().residuals().isHidden());
  model.show(start);
  open_trace(test::trace_table(truth));
  look_for({"X.acceleration", "Y.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  EXPECT_FALSE(view.result().residuals().isHidden());
  const std::vector<ResidualCurves>& curves = view.result().residuals().curves();
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].recording, "scope.csv");
  ASSERT_EQ(curves[0].models.size(), 1U);
  const std::vector<QPointF>& points = curves[0].models[0].points;
  EXPECT_NEAR(points.back().x(), truth.trajectory->duration(), 0.1);
  for (const QPointF& point : points) {
    EXPECT_LT(std::abs(point.y()), 5e-3) << "at " << point.x() << " s";
  }
}

TEST_F(IdentificationViewTest, SaysWhatIsWrongWithATrace) {
  const feedscope::Run other = run_of({}, "G21 G90\nG1 X5 Y90 F6000\nX60 Y-70\nX-20 Y5\nY40\nM30\n");
  model.show(start);
  open_trace(test::trace_table(other, 0));
  EXPECT_THAT(view.recordings().note().toStdString(), HasSubstr("scope.csv: "));
  view.identify();
  ASSERT_TRUE(wait());
  EXPECT_EQ(view.result().chosen(), nullptr);
  EXPECT_THAT(view.message().toStdString(), HasSubstr("does not belong to its program"));
}

TEST_F(IdentificationViewTest, TheWheelOnItsWayChoosesNoMachine) {
  QComboBox& machines = view.choice().machines();
  const int before = machines.currentIndex();
  QWheelEvent turn({5, 5}, machines.mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, {},
                   Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&machines, &turn);
  EXPECT_EQ(machines.currentIndex(), before);
}

/// As wide as the panel is in a window of 1280x800, in the language with the longest names.
TEST(FitChoice, ShowsTheMachineAndAllModelsWholeOnASmallScreen) {
  speak(QStringLiteral("fr"));
  Workbench model{shipped_machines(), make_setup({})};
  FitChoice choice(model);
  choice.resize(355, 600);
  choice.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&choice));
  const auto& machines = *choice.findChild<QComboBox*>();
  QStyleOptionComboBox option;
  option.initFrom(&machines);
  const QRect field =
      machines.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &machines);
  EXPECT_LE(machines.fontMetrics().horizontalAdvance(machines.currentText()), field.width())
      << machines.currentText().toStdString();
  QListWidget& models = choice.models();
  for (int row = 0; row < models.count(); ++row) {
    const QRect place = models.visualItemRect(models.item(row));
    const int box = models.style()->pixelMetric(QStyle::PM_IndicatorWidth) + 8;
    const QString text = models.item(row)->text();
    const QRect needed =
        models.fontMetrics().boundingRect(QRect(0, 0, place.width() - box, 1000), Qt::TextWordWrap, text);
    EXPECT_GE(place.height(), needed.height()) << text.toStdString();
    EXPECT_LE(place.right(), models.viewport()->width()) << text.toStdString();
  }
  speak(QStringLiteral("en"));
}

TEST_F(IdentificationViewTest, BeginsWithATypicalMachineOfEachModelWhereThatIsWanted) {
  model.show(start);
  QComboBox& machines = view.choice().machines();
  machines.setCurrentIndex(machines.findText("Typical machine of each model"));
  emit machines.activated(machines.currentIndex());
  tick_model("grbl");
  ASSERT_EQ(view.choice().starts().size(), 2U);
  EXPECT_EQ(view.choice().starts()[0].setup.machine.id, "grbl-router");
  EXPECT_EQ(view.choice().starts()[1].setup.machine.id, "linuxcnc-mill");
  EXPECT_THAT(view.choice().starts()[0].keys, testing::Contains("junction_deviation_mm"));
  EXPECT_THAT(view.choice().starts()[1].keys, testing::Not(testing::Contains("junction_deviation_mm")));
  machines.setCurrentIndex(machines.findData("dmg-mori-evo40"));
  emit machines.activated(machines.currentIndex());
  EXPECT_EQ(view.choice().starts()[1].setup.machine.id, "dmg-mori-evo40");
}

TEST_F(IdentificationViewTest, CanBeCancelledAndBegunAgain) {
  model.show(start);
  open_trace(test::trace_table(truth));
  view.identify_button().click();
  ASSERT_TRUE(view.busy());
  view.identify_button().click();
  ASSERT_TRUE(wait());
  EXPECT_EQ(view.message(), "Cancelled.");
  EXPECT_EQ(view.result().chosen(), nullptr);
  EXPECT_TRUE(view.identify_button().isEnabled());
}

TEST_F(IdentificationViewTest, ForgetsWithTheProgram) {
  model.show(start);
  open_trace(test::trace_table(truth));
  look_for({"X.acceleration"});
  view.identify();
  ASSERT_TRUE(wait());
  ASSERT_NE(view.result().chosen(), nullptr);
  model.open(files.write("other.nc", "G21 G90\nG1 X5 Y90 F6000\nM30\n"));
  EXPECT_EQ(view.result().chosen(), nullptr);
  ASSERT_TRUE(wait());
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Step 1"));
}

/// A trace of LinuxCNC itself.
TEST_F(IdentificationViewTest, FindsTheMachineOfLinuxCncsTrace) {
  const auto traces = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "linuxcnc" / "traces";
  if (!std::filesystem::exists(traces / "tapie_bore.txt.gz")) {
    GTEST_SKIP() << "no traces of LinuxCNC at " << traces;
  }
  model.open(traces / "tapie_bore.ngc");
  ASSERT_TRUE(wait());
  model.traces().add(traces / "tapie_bore.txt.gz");
  ASSERT_TRUE(wait());
  view.identify();
  ASSERT_TRUE(wait());
  const Identification* found = view.result().chosen();
  ASSERT_NE(found, nullptr) << view.message().toStdString();
  EXPECT_TRUE(found->explains);
  const auto y = std::ranges::find(found->parameters, "Y.acceleration",
                                   [](const IdentifiedParameter& one) { return one.parameter.key; });
  ASSERT_NE(y, found->parameters.end());
  EXPECT_TRUE(y->told);
  EXPECT_NEAR(y->value, 1, 0.01) << "of the machine that the control ran with";
}

}  // namespace
}  // namespace feedscope::ui
