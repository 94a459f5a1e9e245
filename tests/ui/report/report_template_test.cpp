#include "ui/report/report_template.h"

#include <gmock/gmock.h>

#include <QLocale>

#include "core/base/error.h"
#include "tests/support/folders.h"
#include "ui/language/language.h"
#include "ui/report/report.h"

namespace feedscope::ui {
namespace {

const QStringList known{"title", "comparison_table", "notes"};

QString fill(const QString& text, const QString& notes = {}) {
  return ReportTemplate(text, "page.html", known).filled([&](const QString& name) {
    return name == "notes" ? notes : '<' + name + '>';
  });
}

std::string refusal(const QString& text) {
  try {
    const ReportTemplate page(text, "page.html", known);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReportTemplate, PutsBlocksInPlaceOfPlaceholders) {
  EXPECT_EQ(fill("a {{title}} b {{ title }} {single} c"), "a <title> b <title> {single} c");
  EXPECT_EQ(fill("{{comparison_table}}"), "<comparison_table>");
  EXPECT_EQ(fill(""), "");
  EXPECT_EQ(fill("a{{! a remark }}b"), "ab");
}

TEST(ReportTemplate, PutsBlocksIntoTexts) {
  EXPECT_EQ(fill("a {{\"of %1, 100 %, %2 and %1\" title notes}} b", "N"),
            "a of <title>, 100 %, N and <title> b");
  EXPECT_EQ(fill("{{\"alone\"}}"), "alone");
  EXPECT_EQ(fill("{{#notes}}{{\"Notes\"}}{{/notes}}"), "");
  const ReportTemplate page("{{\"of %1\" title}}{{notes}}", "page.html", known);
  EXPECT_EQ(page.placeholders(), (QStringList{"title", "notes"}));
  EXPECT_THAT(refusal("\n{{\"of %1\" titel}}"),
              testing::HasSubstr("page.html:2: unknown placeholder '{{titel}}'"));
  EXPECT_EQ(refusal("{{\"of %1}}"), "page.html:1: the text \"of %1 has no quote at its end");
}

TEST(ReportTemplate, TextsAreInTheLanguageInForceIfTheyHaveATranslation) {
  speak("fr");
  EXPECT_EQ(fill("{{\"Notes\"}} {{\"Where does the time go?\"}} {{\"of my own\"}} Control models"),
            QString("Notes Où passe le temps%1? of my own Control models").arg(QChar(0xa0)));
  speak("en");
  EXPECT_EQ(fill("{{\"Where does the time go?\"}}"), "Where does the time go?");
  QLocale::setDefault(QLocale::c());
}

TEST(ReportTemplate, LeavesOutASectionWhoseBlockIsEmpty) {
  const QString page = "a{{#notes}}<h2>{{title}}</h2>{{notes}}{{/notes}}b";
  EXPECT_EQ(fill(page), "ab");
  EXPECT_EQ(fill(page, "N"), "a<h2><title></h2>Nb");
  EXPECT_EQ(fill("{{#notes}}a{{#title}}b{{/title}}c{{/notes}}d"), "d");
  EXPECT_EQ(fill("{{#title}}a{{#notes}}b{{/notes}}c{{/title}}d"), "acd");
}

TEST(ReportTemplate, OmitsASectionThatIsNotAskedFor) {
  const ReportTemplate page("a{{?more}}b{{#notes}}c{{notes}}{{/notes}}{{/more}}d{{title}}", "page.html",
                            known);
  const auto fill_with = [&](const QStringList& with) {
    return page.filled([](const QString& name) { return name.left(1).toUpper(); }, with);
  };
  EXPECT_EQ(fill_with({}), "adT");
  EXPECT_EQ(fill_with({"more"}), "abcNdT");
  EXPECT_EQ(fill_with({"all"}), "abcNdT");
  EXPECT_EQ(page.placeholders({}), QStringList{"title"});
  EXPECT_EQ(page.placeholders({"more"}), (QStringList{"notes", "title"}));
  EXPECT_EQ(page.sections(), QStringList{"more"});
  EXPECT_THAT(refusal("{{?more}}"), testing::HasSubstr("section '{{#more}}' is not closed"));
}

TEST(ReportTemplate, AsksForEachBlockOnce) {
  int asked = 0;
  const ReportTemplate page("{{#title}}{{title}}{{title}}{{/title}}", "page.html", known);
  EXPECT_EQ(page.filled([&](const QString&) { return QString::number(++asked); }), "11");
  EXPECT_EQ(page.placeholders(), QStringList{"title"});
}

TEST(ReportTemplate, NamesFileLineAndNearestPlaceholder) {
  EXPECT_EQ(refusal("one\ntwo {{comparision_table}}\n"),
            "page.html:2: unknown placeholder '{{comparision_table}}'; did you mean '{{comparison_table}}'?");
  EXPECT_THAT(refusal("{{qwertyuiop}}"), testing::HasSubstr("known: title, comparison_table, notes"));
  EXPECT_THAT(refusal("{{#titel}}"), testing::HasSubstr("did you mean '{{title}}'?"));
}

TEST(ReportTemplate, RefusesWhatIsNotClosed) {
  EXPECT_EQ(refusal("\n\n{{title"), "page.html:3: '{{' without '}}'");
  EXPECT_EQ(refusal("{{#notes}}\n"),
            "page.html:1: section '{{#notes}}' is not closed; write '{{/notes}}' after it");
  EXPECT_EQ(refusal("{{/notes}}"), "page.html:1: '{{/notes}}' closes no section");
  EXPECT_EQ(refusal("{{#notes}}{{/title}}"),
            "page.html:1: '{{/title}}' closes no section; '{{#notes}}' is open");
}

TEST(ReportTemplate, TheShippedOneHoldsEveryBlock) {
  QStringList blocks = report_placeholders();
  blocks.removeOne("summary");  // for templates that do not begin with the decision: says it a second time
  EXPECT_THAT(load_report_template().placeholders(), testing::UnorderedElementsAreArray(blocks));
}

TEST(ReportTemplate, TheReadmeNamesEveryPlaceholder) {
  const QString readme = read_template(QStringLiteral(FEEDSCOPE_SOURCE_DIR "/resources/report/README.md"));
  for (const QString& name : report_placeholders()) {
    EXPECT_TRUE(readme.contains('`' + name + '`')) << name.toStdString();
  }
}

TEST(ReportTemplate, NamesAFileThatCannotBeRead) {
  EXPECT_THAT(
      [] { load_report_template("nowhere/page.html"); },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("cannot read the template 'nowhere/page.html'")));
}

}  // namespace
}  // namespace feedscope::ui
