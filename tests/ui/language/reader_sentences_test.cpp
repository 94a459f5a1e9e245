#include "ui/language/reader_sentences.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/machine/import/machine_import.h"
#include "core/models/grbl/grbl_reading.h"
#include "core/models/klipper/klipper_reading.h"
#include "core/program/program.h"
#include "tests/support/folders.h"
#include "tests/ui/language/source_literals.h"
#include "ui/language/composed_text.h"
#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

const std::filesystem::path checkout = FEEDSCOPE_SOURCE_DIR;

/// A pattern, of core ("{:.3f}") or ours ("%1"), with "{}" for every place, or several side by side.
std::string with_plain_places(const std::string& pattern) {
  static const QRegularExpression places(QStringLiteral("(%\\d|\\{[^}]*\\})+"));
  return QString::fromStdString(pattern).replace(places, QStringLiteral("{}")).toStdString();
}

std::set<std::string> all_patterns() {
  std::set<std::string> all;
  for (const auto& of_reader :
       {general_sentences(), iso_sentences(), sinumerik_sentences(), heidenhain_sentences(),
        control_sentences(), import_sentences(), failure_sentences()}) {
    for (const char* const text : of_reader) {
      EXPECT_TRUE(all.insert(text).second) << "twice: " << text;
    }
  }
  return all;
}

/// What is no message and no hint, or a part of one that the patterns hold as a whole.
const std::set<std::string>& no_patterns() {
  static const std::set<std::string> known{
      // Names.
      "Sinumerik 840D", "Heidenhain DIN/ISO", "Okuma OSP", "standard input",
      // Shown elsewhere: where a radius is from; refused options.
      "asked for", "tool table", "not known", "dialect: \"{}\" is not known{}; give one of {}",
      ", did you mean \"{}\"?",
      // Parts of messages.
      "M{} calls program {}", "M{} calls file {}", "macro program {} is called", "o{} is called",
      "{}, which is neither in the program nor in a file in its folder", "{} without D", "{} without {}",
      "{} without D: the radius of the tool is not known", "G{} without P", "G{} without R",
      "the path shown is the programmed contour; write {}", "T and M6 before it, or D",
      "D with the tool's offset", "{} begins while the position of {} is not known",
      "{} without {}, the bottom of the hole", "{} without R, the retract plane", "{} {}",
      "with pecks of {} mm", "without Q", "{} (hole pattern) needs an active drilling cycle, I and L",
      "{} without {} and {}", "{} without a decimal point is used as {} {}", "cycle {} ({})", "cycle {}",
      "{} is not supported", "M{} ({}) is not supported", "{}; write R", "{} {} mm is zero or negative",
      "tolerance {} mm of CYCLE832", "tolerance {} of {}", "the tolerance T{}", "the last one is {}", "axis ",
      "{} moves to {}, which is not simulated", " in a feed move", "{}; {}", "the array",
      "{} without a tool: its radius is not known", "label {} does not exist {}", "in the program",
      "after this line", "before this line", "{}={} is negative",
      "no position of the rotary axes of machine '{}' gives the tool the direction {}, {}, {} of {}",
      "the tool vector", "the tilted plane", " in the part as it is turned", "G187 (smoothness)",
      "G5.1 (machining condition from speed to accuracy)", "{} of {} changes nothing in the simulation"};
  return known;
}

/// A text with words, which is neither a pattern nor known to be none, is a message without translation.
TEST(ReaderSentences, HaveEveryMessageOfTheSourcesOfTheReaders) {
  std::set<std::string> patterns;
  for (const std::string& pattern : all_patterns()) {
    patterns.insert(with_plain_places(pattern));
  }
  std::vector<std::filesystem::path> sources{checkout / "core/toolpath/rotary_resolver.cpp",
                                             checkout / "core/toolpath/rotary_notes.cpp",
                                             checkout / "core/toolpath/rotary_positions.cpp",
                                             checkout / "core/analysis/contour/chord_error.cpp",
                                             checkout / "core/models/grbl/grbl_reading.cpp",
                                             checkout / "core/models/grbl/grbl_line.cpp",
                                             checkout / "core/models/grbl/grbl_arc_words.cpp",
                                             checkout / "core/models/klipper/klipper_reading.cpp",
                                             checkout / "core/models/klipper/klipper_limits.cpp"};
  // What these say is in composed_text, or on the page of messages.
  const std::set<std::string> others{"path_control.cpp", "program_unit.cpp", "message_codes.h",
                                     "message_codes.cpp"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(checkout / "core/program")) {
    const std::string ending = entry.path().extension().string();
    if ((ending == ".cpp" || ending == ".h") && !others.contains(entry.path().filename().string())) {
      sources.push_back(entry.path());
    }
  }
  static const QRegularExpression words(QStringLiteral("[a-z]{2}.* | .*[a-z]{2}"));
  std::size_t messages = 0;
  for (const std::filesystem::path& source : sources) {
    for (const std::string& literal : source_literals(source)) {
      const std::string text = with_plain_places(literal);
      if (patterns.contains(text)) {
        ++messages;
      } else if (words.match(QString::fromStdString(text)).hasMatch()) {
        EXPECT_TRUE(no_patterns().contains(text)) << source.filename() << ": " << literal;
      }
    }
  }
  EXPECT_GT(messages, 700U);
}

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
      for (const std::string& text : {diagnostic.message, diagnostic.hint}) {
        if (!text.empty() && said_.insert(text).second) {
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

  static void expect_french(const std::string& code, const std::string& text) {
    static const QRegularExpression quoted(QStringLiteral("\"[^\"]*\"+|'[^' ]*'"));
    static const QRegularExpression english(QStringLiteral(
        "\\b(the|of|and|is|are|by|at|within|without|with|off|times|not|axis|line|lines|it|its|in|to|write|"
        "used|"
        "supported|from|only|shown|tool|feed|block|program|label|number|known|value|which)\\b"));
    const QString made = composed_text(text);
    EXPECT_NE(made.toStdString(), text) << code;
    QString rest = made;
    rest.remove(quoted);
    for (const char* name : {"--tool", "--wear-only"}) {
      rest.remove(QLatin1String(name));
    }
    EXPECT_FALSE(english.match(rest).hasMatch()) << code << ": " << text << "\n  " << made.toStdString();
  }

  std::set<std::string> said_;
};

constexpr std::array every_dialect{Dialect::fanuc,     Dialect::linuxcnc,   Dialect::grbl,
                                   Dialect::sinumerik, Dialect::heidenhain, Dialect::heidenhain_iso};

TEST_F(FrenchMessages, OfSamplesAndTestPrograms) {
  read_folder(checkout / "resources/programs");
  for (const char* folder : {"benchmark", "contract", "oracle/programs", "render"}) {
    read_folder(checkout / "tests" / folder);
  }
  EXPECT_GT(said().size(), 20U);
}

/// The tests of the readers hold a short program for nearly every message, in their texts.
TEST_F(FrenchMessages, OfProgramsInTheTestsOfTheReaders) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(checkout / "tests/core/program")) {
    if (entry.path().extension() != ".cpp") {
      continue;
    }
    const bool long_runs = entry.path().filename() == "garbage_test.cpp";
    for (const std::string& program :
         long_runs ? std::vector<std::string>() : source_literals(entry.path())) {
      if (program.find(": error:") != std::string::npos) {
        continue;  // what is said, not a program
      }
      for (const Dialect dialect : every_dialect) {
        read(std::make_shared<SourceText>("part.nc", program), dialect);
      }
      read(std::make_shared<SourceText>("part.nc", program), std::nullopt, "ABC");
    }
  }
  EXPECT_GT(said().size(), 500U);
}

TEST_F(FrenchMessages, OfConfigurationsInTheTestsOfImports) {
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(checkout / "tests/core/machine/import")) {
    for (const std::string& text : source_literals(entry.path())) {
      try {
        look_at(import_machine_text(text, "machine", machine_file_settings()).notes);
      } catch (const InputError&) {  // no configuration
      }
    }
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
  const Program by_grbl = read_as_grbl(std::make_shared<SourceText>("part.nc", for_grbl), 0.002F);
  EXPECT_GE(by_grbl.diagnostics.size(), 28U);
  look_at(by_grbl.diagnostics);
  const KlipperSettings limits(Machine(), complete_settings(find_model("klipper"), Machine()));
  const Program by_klipper =
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
      for (const std::string& text : {one.message, one.hint}) {
        const QString french = composed_text(text);
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
  EXPECT_EQ(composed_text(std::string("\"F2.5\" is used; remove the other")).toStdString(),
            "\"F2.5\" est utilisé\u00a0; supprimez l’autre");
  EXPECT_EQ(composed_text(std::string("feed F-2.5 is not above zero")).toStdString(),
            "l’avance F-2.5 n’est pas supérieure à zéro");
  EXPECT_EQ(composed_text(std::string("the rounding of 2.500 mm: it is adjacent to a rapid")).toStdString(),
            "arrondi de 2,500 mm\u00a0: il touche un déplacement rapide");
  EXPECT_EQ(composed_text(std::string("\"%1 and %2\" is not a known G word")).toStdString(),
            "\"%1 and %2\" n’est pas un mot G connu");
}

}  // namespace
}  // namespace feedscope::ui
