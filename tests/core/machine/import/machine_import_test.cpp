#include "core/base/error.h"
#include "tests/core/machine/import/import_fixture.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class MachineImport : public test::ImportTest {};

TEST_F(MachineImport, FindsTheKindByTheContent) {
  EXPECT_EQ(configuration_kind("[EMC]\nMACHINE=a\n[TRAJ]\n"), "INI file of LinuxCNC");
  EXPECT_EQ(configuration_kind("\xEF\xBB\xBF$100=1\r\n$101=1\r\n$102=1\r\n"), "listing of grbl settings");
  EXPECT_EQ(configuration_kind("[printer]\nkinematics: none\n"), "configuration of Klipper");
  EXPECT_EQ(configuration_kind(""), "");
  EXPECT_EQ(configuration_kind(std::string("[EMC]\n[TRAJ]\n\0", 14)), "");
  EXPECT_EQ(configuration_kind("[Desktop Entry]\nName=x\n"), "");
}

TEST_F(MachineImport, TakesNoProgramForAConfiguration) {
  const fs::path folder = fs::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs";
  std::size_t programs = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    EXPECT_EQ(configuration_kind_of(entry.path()), "") << entry.path();
    ++programs;
  }
  EXPECT_GT(programs, 20U);
  const fs::path corpus = fs::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "corpus";
  if (!fs::exists(corpus)) {
    GTEST_SKIP() << "no " << corpus;
  }
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(corpus)) {
    EXPECT_EQ(configuration_kind_of(entry.path()), "") << entry.path();
  }
}

TEST_F(MachineImport, RefusesOtherFilesByName) {
  write("part.nc", "G0 X1\n");
  EXPECT_THAT([&] { import_file("part.nc"); },
              ThrowsMessage<InputError>(
                  HasSubstr("part.nc' is not the configuration of a control that can be imported; "
                            "known: INI file of LinuxCNC")));
  EXPECT_THAT([&] { import_file("none.ini"); },
              ThrowsMessage<InputError>(HasSubstr("cannot read configuration")));
  EXPECT_THAT([&] { import_machine(folder_, specs()); }, ThrowsMessage<InputError>(HasSubstr("is a folder")));
  EXPECT_EQ(configuration_kind_of(folder_), "");
}

TEST_F(MachineImport, ReadsOtherEncodings) {
  const std::string listing = "$110=5000 (\xB0)\n$111=4000\n$112=500\n$\xE9=1\n";
  EXPECT_NEAR(import(listing, "latin.txt").machine.axes[0].velocity, 5000.0 / 60, 1e-9);
  EXPECT_EQ(notes(import(listing, "latin.txt"), "latin.txt"),
            "latin.txt:4: info: '$\xC3\xA9=1' is not a setting; it is skipped [not-understood]\n");
  std::string wide = "\xFF\xFE";  // as a redirected output of PowerShell
  for (const char c : std::string("$110=5000\r\n$111=4000\r\n$112=500\r\n")) {
    wide += {c, '\0'};
  }
  EXPECT_EQ(configuration_kind(wide), "listing of grbl settings");
  EXPECT_EQ(source(import(wide, "wide.txt"), "Y.velocity"), "wide.txt, line 2: $111 = 4000 mm/min");
  const ImportedMachine named =
      import("[EMC]\nMACHINE = Fr\xE4se \xE2\x82\xAC\n[TRAJ]\nLINEAR_UNITS = mm\n", "a.ini");
  EXPECT_EQ(named.machine.name, "Fr\xC3\xA4se \xE2\x82\xAC");
}

TEST_F(MachineImport, ListsAtMostTwoHundredNotes) {
  std::string text = "[EMC]\n[TRAJ]\nLINEAR_UNITS = mm\n";
  for (int i = 0; i < 1000; ++i) {
    text += "what is this\n";
  }
  const ImportedMachine imported = import(text + "[AXIS_X]\nMAX_VELOCITY = -1\n", "a.ini");
  ASSERT_EQ(imported.notes.size(), 201U);
  EXPECT_THAT(imported.notes.back().message.english(), HasSubstr("more notes are not listed"));
  EXPECT_EQ(imported.notes.back().severity, Severity::error) << "one of them is an error";
}

TEST_F(MachineImport, MakesAnIdOfTheFileName) {
  write("my old mill.ini", "[EMC]\n[TRAJ]\nLINEAR_UNITS = mm\n");
  EXPECT_EQ(import_file("my old mill.ini").machine.id, "my-old-mill");
}

}  // namespace
}  // namespace feedscope
