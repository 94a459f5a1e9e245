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

TEST_F(MachineImport, MakesAnIdOfTheFileName) {
  write("my old mill.ini", "[EMC]\n[TRAJ]\nLINEAR_UNITS = mm\n");
  EXPECT_EQ(import_file("my old mill.ini").machine.id, "my-old-mill");
}

}  // namespace
}  // namespace feedscope
