#include "ui/language/failure_text.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/load/load_file.h"
#include "core/trace/read_trace.h"
#include "core/trace/trace_columns.h"
#include "tests/support/folders.h"
#include "tests/ui/language/source_literals.h"
#include "ui/language/language.h"
#include "ui/language/reader_sentences.h"

namespace feedscope::ui {
namespace {

const std::filesystem::path sources = FEEDSCOPE_SOURCE_DIR;

/// What `source` throws: the texts between the parentheses of InputError(), fail() and refuse().
std::vector<std::string> thrown_texts(const std::filesystem::path& source, const QTemporaryDir& folder) {
  std::ifstream in(source);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::string thrown;
  for (const char* const call : {"throw InputError(", "throw input_error(", "fail(", "refuse("}) {
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
      std::size_t end = at + std::string_view(call).size();
      bool in_quotes = false;
      for (int open = 1; open > 0 && end < text.size(); ++end) {
        in_quotes = in_quotes != (text[end] == '"' && text[end - 1] != '\\');
        open += in_quotes ? 0 : text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
      }
      thrown += text.substr(at, end - at) + ";\n";
    }
  }
  const std::filesystem::path extract = folder.filePath("thrown.cpp").toStdString();
  std::ofstream(extract) << thrown;
  return source_literals(extract);
}

std::string with_bare_places(const std::string& pattern) {
  static const QRegularExpression places(QStringLiteral("(%\\d|\\{[a-z0-9:.]*\\})+"));
  return QString::fromStdString(pattern)
      .replace(places, QStringLiteral("{}"))
      .replace("{{", "{")
      .replace("}}", "}")
      .toStdString();
}

TEST(FailureText, HasAPatternForWhateverFilesOfTheWindowAreRefusedFor) {
  const QTemporaryDir folder;
  std::set<std::string> patterns;
  for (const auto& of_part : {general_sentences(), iso_sentences(), sinumerik_sentences(),
                              heidenhain_sentences(), import_sentences(), failure_sentences()}) {
    for (const char* const pattern : of_part) {
      patterns.insert(with_bare_places(pattern));
    }
  }
  // Parts of a pattern, and what only the command line or a fault of our own can ask for.
  const std::set<std::string> others{
      "column specification: {}={} must be a number from {} to {}",
      "column specification: separator={} must be tab, comma, semicolon or blank",
      "column specification: decimal={} must be point or comma",
      "column specification: {}= needs the number or the name of a column, such as {}=2",
      "column specification: unit '{}' of {} is not known; known: {}",
      "column specification: {} cannot have an offset, {}; positions of axes can",
      "column specification: unknown key '{}'; {}",
      "column specification: '{}' is not KEY=VALUE",
      "{}: unknown key '{}' in {}; {}",
      "{}:{}:{}: not valid TOML: {}",
      "value of {} must be a number{}",
      " or text",
      "{}{} = {} is out of bounds; it must be {}",
      "{}{} = '{}' is text; it must be a number {}",
      "{}{} = '{}' is not a valid choice; it must be one of: {}",
      "setting '{}' is the text '{}', not a number",
      "setting '{}' is the number {}, not a text",
      "has the word frame twice",
      "has '{}', which is no axis of this machine",
      "has {} twice",
      "none"};
  static const QRegularExpression words(QStringLiteral("[a-z]{2}.* | .*[a-z]{2}"));
  std::size_t messages = 0;
  for (const char* const part : {"core/trace", "core/load", "core/machine"}) {
    for (const auto& entry : std::filesystem::directory_iterator(sources / part)) {
      if (entry.path().extension() != ".cpp") {
        continue;
      }
      for (const std::string& literal : thrown_texts(entry.path(), folder)) {
        const std::string text = with_bare_places(literal);
        if (patterns.contains(text)) {
          ++messages;
        } else if (words.match(QString::fromStdString(text)).hasMatch()) {
          EXPECT_TRUE(others.contains(text)) << entry.path().filename() << ": " << literal;
        }
      }
    }
  }
  EXPECT_GT(messages, 50U);
}

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

TEST_F(FrenchFailures, OfSessionsSayWhyBehindTheFile) {
  EXPECT_EQ(
      failure_text(std::string("cannot use session 'a.feedscope': it names no program: \"program\" has no "
                               "\"file\""))
          .toStdString(),
      "la session 'a.feedscope' ne peut pas être utilisée : elle ne nomme pas de programme : "
      "\"program\" n’a pas de \"file\"");
}

TEST(FailureText, IsAsItWasThrownInEnglish) {
  const std::string thrown = "part.toml:3:1: 'a' in [b] must be a table";
  EXPECT_EQ(failure_text(thrown).toStdString(), thrown);
}

}  // namespace
}  // namespace feedscope::ui
