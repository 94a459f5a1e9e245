#include "core/analysis/run/control_dialect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/analysis/notes/remarks.h"
#include "tests/support/english.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Where any shipped machine has a control for the dialect, the default is one of them.
TEST(DefaultMachine, HasAControlForTheDialectWhereAShippedMachineHas) {
  const MachineLibrary library = shipped_machines();
  for (const DialectInfo& info : all_dialects()) {
    const bool any = std::ranges::any_of(library.ids(), [&](const std::string& id) {
      return control_reads(library.load(id), info.dialect).value_or(false);
    });
    const Machine machine = library.load(default_machine_of(info.dialect));
    EXPECT_EQ(control_reads(machine, info.dialect).value_or(false), any) << info.id;
    SetupRequest request;
    request.dialect = info.dialect;
    EXPECT_EQ(make_setup(request).machine, machine) << info.id;
    request.machine = "huron-kx10";
    EXPECT_EQ(make_setup(request).machine.id, "huron-kx10") << info.id;
  }
}

/// Or the machine is of no particular control.
TEST(ControlDialect, EveryShippedControlIsKnown) {
  const MachineLibrary library = shipped_machines();
  for (const std::string& id : library.ids()) {
    const bool reads_any = std::ranges::any_of(all_dialects(), [&](const DialectInfo& info) {
      return control_reads(library.load(id), info.dialect).value_or(false);
    });
    EXPECT_TRUE(reads_any || library.load(id).control.starts_with("any")) << id;
  }
}

TEST(ControlDialect, NamesAreReadWhateverTheirCaseAndUnknownOnesSayNothing) {
  Machine machine;
  machine.control = "FANUC 31i-B5";
  EXPECT_EQ(control_reads(machine, Dialect::fanuc), true);
  EXPECT_EQ(control_reads(machine, Dialect::sinumerik), false);
  EXPECT_EQ(control_reads(machine, Dialect::iso), std::nullopt);
  machine.control = "Heidenhain iTNC 530";
  EXPECT_EQ(control_reads(machine, Dialect::heidenhain_iso), true);
  machine.control = "a control of our own";
  EXPECT_EQ(control_reads(machine, Dialect::fanuc), std::nullopt);
  EXPECT_FALSE(control_mismatch(machine, Dialect::fanuc));
}

TEST(ControlDialect, AMismatchNamesBothAndWhatToDo) {
  const Machine spinner = shipped_machines().load("spinner-mvc850");
  EXPECT_FALSE(control_mismatch(spinner, Dialect::sinumerik));
  EXPECT_FALSE(control_mismatch(spinner, Dialect::iso));
  const auto heidenhain = control_mismatch(spinner, Dialect::heidenhain);
  ASSERT_TRUE(heidenhain);
  EXPECT_THAT(describe(*heidenhain).english(),
              AllOf(HasSubstr("Heidenhain"), HasSubstr("Spinner MVC 850"),
                    HasSubstr("Siemens Sinumerik 840D"), HasSubstr("dmg-mori-evo40")));
  const auto fanuc = control_mismatch(spinner, Dialect::fanuc);
  ASSERT_TRUE(fanuc);
  EXPECT_THAT(describe(*fanuc).english(), AllOf(HasSubstr("Fanuc"), HasSubstr("your own machine file")));
}

TEST(Remarks, BeginWithTheControlThenWhatIsNotFollowed) {
  const LoadedProgram program =
      load_program(std::make_shared<const SourceText>("a.mpf", "G71\nG642 CTOL=0.02\nG1 X10 F1000\nY10\n"));
  EXPECT_TRUE(remarks(simulate_run(program, make_setup({"spinner-mvc850", "essid", {}}))).empty());
  const std::vector<Remark> all = remarks(simulate_run(program, make_setup({"dmg-mori-evo40", "cam", {}})));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].about, Remark::About::validity);
  EXPECT_THAT(all[0].text.english(), HasSubstr("Heidenhain TNC 640"));
  EXPECT_EQ(all[1].about, Remark::About::path_control);
  EXPECT_THAT(all[1].text.english(), HasSubstr("Tolerances"));
  EXPECT_EQ(all[2].about, Remark::About::values);
  EXPECT_THAT(all[2].text.english(), HasSubstr("jump"));
}

}  // namespace
}  // namespace feedscope
