#include "ui/language/in_language.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/load/load_file.h"
#include "core/machine/file_text.h"
#include "core/trace/read_trace.h"
#include "core/trace/trace_columns.h"
#include "tests/support/folders.h"
#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

class FrenchFailures : public testing::Test {
 protected:
  FrenchFailures() { speak(QStringLiteral("fr")); }
  ~FrenchFailures() override {
    speak(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  std::filesystem::path file(const char* name, const std::string& text) const {
    const std::filesystem::path path = folder_.filePath(name).toStdString();
    std::ofstream(path) << text;
    return path;
  }

  /// What is said of what `work` throws, without the folder of this test.
  std::string said_of(const std::function<void()>& work) const {
    try {
      work();
    } catch (const InputError& error) {
      return failure_text(error).remove(folder_.path() + '/').toStdString();
    }
    return "nothing was thrown";
  }

 private:
  QTemporaryDir folder_;
};

TEST_F(FrenchFailures, OfMachineFilesKeepThePlaceInFront) {
  const auto machine = file("mill.toml", "id = 3\n");
  EXPECT_EQ(said_of([&] { shipped_machines().load(machine.string()); }),
            "mill.toml:1:6: 'id' dans le fichier doit être un texte entre guillemets");
}

TEST_F(FrenchFailures, OfMachinesThatAreNotKnown) {
  EXPECT_EQ(
      said_of([] { shipped_machines().load("linuxcnc-mil"); }),
      "machine 'linuxcnc-mil' inconnue\u00a0: ni identifiant de machine, ni fichier\u00a0; vouliez-vous dire "
      "'linuxcnc-mill' ?");
}

TEST_F(FrenchFailures, OfTraces) {
  const auto trace = file("part.csv", "a;b\n1;2\n3;4\n");
  EXPECT_EQ(said_of([&] { read_trace(trace, {}); }),
            "'part.csv' n’a aucune colonne reconnue comme position de X, Y ou Z\u00a0; colonnes\u00a0: a, "
            "b\u00a0; indiquez "
            "lesquelles, comme --columns x=2:mm,y=3:mm");
  EXPECT_EQ(said_of([] { parse_trace_columns("x=2:kg"); }),
            "spécification des colonnes\u00a0: l’unité 'kg' de x n’est pas connue\u00a0; unités "
            "connues\u00a0: mm, um, nm, m, "
            "in, inch");
}

TEST_F(FrenchFailures, OfLoadFiles) {
  const auto load = file("part.toml", "version = 1\n");
  EXPECT_EQ(said_of([&] { read_load_file(load); }),
            "part.toml:1:1: clé 'version' inconnue dans le fichier\u00a0; sont connus\u00a0: feedscope_load, "
            "operation, "
            "material");
}

TEST_F(FrenchFailures, SayWhyBehindTheFile) {
  EXPECT_EQ(said_of([] { file_text("/", NC_("core", "lesson"), 1); }),
            "'/' est un dossier\u00a0; il faut un fichier\u00a0: leçon");
}

TEST(FailureText, IsAsItWasThrownInEnglish) {
  const InputError thrown(at_place("part.toml:3:1", message(NC_("core", "'{}' in {} must be a table"),
                                                            std::string_view("a"), std::string_view("[b]"))));
  EXPECT_EQ(failure_text(thrown).toStdString(), "part.toml:3:1: 'a' in [b] must be a table");
}

TEST(FailureText, LeavesWhatLibrariesSay) {
  EXPECT_EQ(failure_text(std::runtime_error("bad allocation")).toStdString(), "bad allocation");
}

}  // namespace
}  // namespace feedscope::ui
