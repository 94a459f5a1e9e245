#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/program/controls/grbl_reading.h"
#include "core/program/controls/klipper_reading.h"
#include "core/program/program.h"
#include "tests/support/folders.h"
#include "ui/language/in_language.h"
#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

const std::filesystem::path checkout = FEEDSCOPE_SOURCE_DIR;

class FrenchMessages : public testing::Test {
 protected:
  FrenchMessages() { speak(QStringLiteral("fr")); }
  ~FrenchMessages() override {
    speak(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  /// Reads a program in a dialect, by default the one it seems to have, and looks at all it says.
  void read(std::shared_ptr<const SourceText> source, std::optional<Dialect> dialect = std::nullopt,
            const std::string& rotary_axes = {}) {
    ReadOptions options;
    options.dialect = dialect;
    options.repeat_limit = 500;
    options.rotary_axes = rotary_axes;
    look_at(read_program(std::move(source), nullptr, options).diagnostics);
  }

  void look_at(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
      for (const Message& text : {diagnostic.message, diagnostic.hint}) {
        if (!text.empty() && said_.insert(text.english()).second) {
          expect_french(diagnostic.code, text);
        }
      }
    }
  }

  void read_folder(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string ending = entry.path().extension().string();
      const bool no_program =
          ending == ".py" || ending == ".cpp" || ending == ".txt" || ending == ".md" || ending == ".json";
      if (entry.is_regular_file() && entry.file_size() < largest && !no_program) {
        try {
          read(std::make_shared<SourceText>(SourceText::from_file(entry.path())));
        } catch (const std::exception&) {  // no text
        }
      }
    }
  }

  const std::set<std::string>& said() const { return said_; }

 private:
  static constexpr std::size_t largest = 3'000'000;  ///< of a file [bytes]

  static void expect_french(const std::string& code, const Message& text) {
    static const QRegularExpression quoted(QStringLiteral("\"[^\"]*\"+|'[^' ]*'"));
    static const QRegularExpression english(QStringLiteral(
        "\\b(the|of|and|is|are|by|at|within|without|with|off|times|not|axis|line|lines|it|its|in|to|write|"
        "used|"
        "supported|from|only|shown|tool|feed|block|program|label|number|known|value|which)\\b"));
    const QString made = in_language(text);
    EXPECT_NE(made.toStdString(), text.english()) << code;
    QString rest = made;
    rest.remove(quoted);
    for (const char* name : {"--tool", "--wear-only"}) {
      rest.remove(QLatin1String(name));
    }
    EXPECT_FALSE(english.match(rest).hasMatch()) << code << ": " << text << "\n  " << made.toStdString();
  }

  std::set<std::string> said_;
};

TEST_F(FrenchMessages, OfSamplesAndTestPrograms) {
  read_folder(checkout / "resources/programs");
  for (const char* folder : {"benchmark", "contract", "oracle/programs", "render"}) {
    read_folder(checkout / "tests" / folder);
  }
  EXPECT_GT(said().size(), 20U);
}

/// A line for every reason of a control to reject it.
TEST_F(FrenchMessages, OfLinesThatControlsReject) {
  const std::string for_grbl = "1X\nG\n$H\nF-1\n" + std::string(80, '1') +
                               "\nG5\nD1\nG1 G0\nG90.05\nG28 G92 X1\nX1 X2\nG92\nG10 L2 P9 X1\nG10 X1\nG10 "
                               "L2 P1\nG10 L3 P1 X1\nG53 G2 X1 I1 "
                               "F100\nG1 X1\nF100\nG80 X1\nG2 X10 I1\nG2 X10 R1\nG2 X0 R1\nG2 X10\nG2 I1\nG0 "
                               "X1 P1\nG43.1 X1\nT256\nG4\nG93\n"
                               "G1 X2\n";
  const ReadProgram by_grbl = read_as_grbl(std::make_shared<SourceText>("part.nc", for_grbl), 0.002F);
  EXPECT_GE(by_grbl.diagnostics.size(), 28U);
  look_at(by_grbl.diagnostics);
  const KlipperSettings limits(Machine(), complete_settings(find_model("klipper"), Machine()));
  const ReadProgram by_klipper =
      read_as_klipper(std::make_shared<SourceText>(
                          "part.nc",
                          "G20\nG5\nG1 X1 F0\nG1 X\nG91\nG2 X1 I1\nG90\nG2 X1 R1\nG2 X1\nG4 P-1\nM220 "
                          "S0\nM204\nM204 S-1\n"),
                      limits);
  EXPECT_EQ(by_klipper.diagnostics.size(), 11U);
  look_at(by_klipper.diagnostics);
  EXPECT_EQ(said().size(), by_grbl.diagnostics.size() + by_klipper.diagnostics.size());
}

TEST_F(FrenchMessages, OfTheCorpus) {
  const std::filesystem::path corpus = checkout / ".." / "shared" / "corpus";
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << corpus << " is not there";
  }
  read_folder(corpus);
  EXPECT_GT(said().size(), 100U);
}

/// Names that are texts of the core, too: "error" is what a severity is called, "dwell" a cause.
TEST_F(FrenchMessages, NeverTranslateNamesOfTheProgram) {
  const std::vector<std::pair<Dialect, std::string>> programs{
      {Dialect::fanuc, "M98 (error)\nG65 (dwell)\n#[2.5]=3\nG1 X#[2.5]\nGOTO 2.5\n"},
      {Dialect::linuxcnc, "o<error> call\nG1 X#<dwell> F100\n#[2.5]=3\nM98 P<error>\no<dwell> if [1]\n"},
      {Dialect::sinumerik,
       "GOTOF error\nCALL \"error\"\nerror(1)\nG1 X=dwell F100\nREPEAT error dwell\nEXTCALL "
       "\"dwell\"\nR2.5=1\n"},
      {Dialect::heidenhain,
       "0 BEGIN PGM error MM\n1 CALL PGM error\n2 CALL LBL \"dwell\"\n3 SEL PGM \"error\"\n4 CALL LBL error\n"
       "5 L X+error\n6 FN 9: IF +Q1 EQU +Q2 GOTO LBL \"dwell\"\n"}};
  std::size_t named = 0;
  for (const auto& [dialect, program] : programs) {
    ReadOptions options;
    options.dialect = dialect;
    for (const Diagnostic& one :
         read_program(std::make_shared<SourceText>("part.nc", program), nullptr, options).diagnostics) {
      for (const Message& said : {one.message, one.hint}) {
        const std::string text = said.english();
        const QString french = in_language(said);
        for (const char* name : {"error", "dwell", "2.5"}) {
          const bool is_there = text.find(name) != std::string::npos;
          named += is_there ? 1 : 0;
          EXPECT_TRUE(!is_there || french.contains(name)) << text << "\n  " << french.toStdString();
        }
      }
    }
  }
  EXPECT_GT(named, 8U);
}

TEST_F(FrenchMessages, KeepWordsAndValuesOfTheProgram) {
  const auto french = [](const Message& message) { return in_language(message).toStdString(); };
  EXPECT_EQ(french(message(NC_("core", "feed F{} is not above zero"), -2.5)),
            "l’avance F-2.5 n’est pas supérieure à zéro");
  EXPECT_EQ(french(message(NC_("core", "the {} of {:.3f} mm: {}"), NC_("core", "rounding"), 2.5,
                           NC_("core", "it is adjacent to a rapid"))),
            "arrondi de 2,500 mm\u00a0: il touche un déplacement rapide");
  EXPECT_EQ(french(message(NC_("core", "{} is not a known G word"), std::string_view("\"%1 and {}\""))),
            "\"%1 and {}\" n’est pas un mot G connu");
}

}  // namespace
}  // namespace feedscope::ui
