#include "ui/language/language.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <string>
#include <vector>

#include "core/analysis/unfollowed.h"
#include "core/limits/cause.h"
#include "core/models/control_model.h"
#include "tests/support/folders.h"
#include "ui/language/core_texts.h"
#include "ui/scene/cause_colour.h"

namespace feedscope::ui {
namespace {

void add(std::vector<std::string>& texts, const std::vector<SettingSpec>& specs) {
  for (const SettingSpec& spec : specs) {
    texts.push_back(spec.title);
    texts.push_back(spec.explanation);
  }
}

/// What the window shows of the core.
std::vector<std::string> shown_texts() {
  std::vector<std::string> texts;
  for (const Cause cause : all_causes()) {
    texts.push_back(cause_title(cause));
    texts.push_back(cause_kind_title(cause.kind));
  }
  add(texts, axis_limit_specs());
  for (const ControlModel* model : all_models()) {
    texts.push_back(model->info().title);
    texts.push_back(model->info().summary);
    add(texts, settings_of(*model));
  }
  const std::vector<std::string> sentences = all_unfollowed();
  texts.insert(texts.end(), sentences.begin(), sentences.end());
  return texts;
}

TEST(CoreTexts, TranslatorsSeeEveryTextThatIsShown) {
  const auto known = known_core_texts();
  for (const std::string& text : shown_texts()) {
    EXPECT_NE(std::ranges::find(known, text), known.end()) << text;
  }
}

TEST(Language, FrenchHasEveryTextOfTheCore) {
  QTranslator french;
  ASSERT_TRUE(french.load(":/translations/feedscope_fr"));
  for (const char* text : known_core_texts()) {
    EXPECT_FALSE(french.translate("core", text).isEmpty()) << text;
  }
}

TEST(Language, FrenchHasEveryTextOfTheWindow) {
  QFile file(FEEDSCOPE_SOURCE_DIR "/resources/translations/feedscope_fr.ts");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray texts = file.readAll();
  EXPECT_GT(texts.count("<source>"), 300);
  EXPECT_EQ(texts.count("type=\"unfinished\""), 0);
}

TEST(Language, IsEnglishOrOneOfThoseThatAreShipped) {
  EXPECT_TRUE(languages().contains(chosen_language()));
  EXPECT_TRUE(languages().contains("fr"));
}

}  // namespace
}  // namespace feedscope::ui
