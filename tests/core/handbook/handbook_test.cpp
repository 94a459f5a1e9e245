#include "core/handbook/handbook.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/analysis/run/run.h"
#include "core/models/control_model.h"

namespace feedscope {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::multiline);
  std::vector<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), regex); match != std::sregex_iterator();
       ++match) {
    found.push_back((*match)[1].str());
  }
  return found;
}

/// "%C3%A9" in a link is a byte each.
std::string decoded(const std::string& link) {
  std::string text;
  for (std::size_t i = 0; i < link.size(); ++i) {
    if (link[i] == '%') {
      text += static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      text += link[i];
    }
  }
  return text;
}

class HandbookOf : public testing::TestWithParam<std::string> {
 protected:
  const Handbook handbook{GetParam()};
};

TEST_P(HandbookOf, BeginsWithTheIndexAndEveryPageHasATitle) {
  ASSERT_GT(handbook.pages().size(), 10U);
  EXPECT_EQ(handbook.pages().front().name, "index");
  for (const HandbookPage& page : handbook.pages()) {
    EXPECT_FALSE(page.title.empty()) << page.name;
    EXPECT_EQ(matches(page.markdown, "^# (.+)$").size(), 1U) << page.name;
  }
}

TEST_P(HandbookOf, EveryLinkLeadsToAPageAndAHeading) {
  for (const HandbookPage& page : handbook.pages()) {
    const std::string html = page_html(page, ".html");
    for (const std::string& link : matches(html, "href=\"([^\"]*)\"")) {
      if (link.starts_with("http")) {
        continue;
      }
      const std::size_t hash = link.find('#');
      const std::string file = link.substr(0, hash);
      const std::string name = file.empty() ? page.name : file.substr(0, file.find(".html"));
      const HandbookPage* const target = handbook.find(name);
      ASSERT_NE(target, nullptr) << page.name << ": " << link;
      if (hash != std::string::npos) {
        const std::string anchor = "name=\"" + decoded(link.substr(hash + 1)) + "\"";
        EXPECT_THAT(page_html(*target, ".html"), HasSubstr(anchor)) << page.name << ": " << link;
      }
    }
  }
}

TEST_P(HandbookOf, HasTheSamePagesAndChaptersAsTheEnglishOne) {
  const Handbook english("en");
  ASSERT_EQ(handbook.pages().size(), english.pages().size());
  for (std::size_t i = 0; i < english.pages().size(); ++i) {
    EXPECT_EQ(handbook.pages()[i].name, english.pages()[i].name);
    EXPECT_EQ(matches(handbook.pages()[i].markdown, "^(##) ").size(),
              matches(english.pages()[i].markdown, "^(##) ").size())
        << english.pages()[i].name;
  }
}

TEST_P(HandbookOf, LeavesNoTableAsBars) {
  for (const HandbookPage& page : handbook.pages()) {
    const std::string html = page_html(page, ".html");
    EXPECT_EQ(matches(html, "^(<p>\\|)").size(), 0U) << page.name;
    EXPECT_EQ(matches(html, "(<table)").size(), matches(page.markdown, "^(\\|-)").size()) << page.name;
  }
}

TEST_P(HandbookOf, IsPagesThatLinkEachOther) {
  const std::string index = whole_page_html(handbook.pages().front(), GetParam());
  EXPECT_THAT(index, HasSubstr("<html lang=\"" + GetParam() + "\">"));
  EXPECT_THAT(index, HasSubstr("href=\"first-steps.html\""));
  EXPECT_THAT(whole_page_html(handbook.pages().back(), GetParam()), HasSubstr("href=\"index.html\""));
  for (const std::string& link : matches(index, "href=\"([^\"#]+)[.]html\"")) {
    EXPECT_NE(handbook.find(link), nullptr) << link;
  }
}

/// Machines on the page of machine files as `id`, models on that of their accuracy as **id**.
TEST_P(HandbookOf, NamesEveryMachineAndModel) {
  const std::string& machines = handbook.find("machine-files")->markdown;
  const MachineLibrary shipped = shipped_machines();
  for (const std::string& id : shipped.ids()) {
    EXPECT_THAT(machines, HasSubstr("`" + id + "`"));
  }
  const std::string& trust = handbook.find("trust")->markdown;
  for (const ControlModel* model : all_models()) {
    EXPECT_THAT(trust, HasSubstr("**" + model->info().id + "**"));
  }
}

/// Settings that a tolerance of a control becomes.
TEST_P(HandbookOf, NamesNoSettingThatIsGone) {
  std::set<std::string> known;
  for (const ControlModel* model : all_models()) {
    const std::vector<std::string> keys = assignable_keys(*model);
    known.insert(keys.begin(), keys.end());
  }
  const std::vector<std::string> named = matches(handbook.find("tolerance-on-your-control")->markdown,
                                                 "`([a-z]+(?:_[a-z0-9]+)*_(?:mm|um|ms|s|m_s3|mm_s))[`=]");
  EXPECT_GT(named.size(), 5U);
  for (const std::string& key : named) {
    EXPECT_TRUE(known.contains(key)) << key;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, HandbookOf, testing::Values("en", "fr"),
                         [](const auto& tested) { return tested.param; });

TEST(Handbook, ALanguageThatItDoesNotHaveIsEnglish) {
  EXPECT_EQ(Handbook("xx").pages().front().title, Handbook("en").pages().front().title);
}

TEST(Handbook, SearchFindsPagesThatHoldEveryWord) {
  const Handbook handbook("en");
  EXPECT_EQ(handbook.search("").size(), handbook.pages().size());
  const auto found = handbook.search("  EXIT codes ");
  EXPECT_THAT(found, testing::Contains(handbook.find("command-line")));
  EXPECT_LT(found.size(), handbook.pages().size());
  EXPECT_TRUE(handbook.search("exit zzzzqq").empty());
}

}  // namespace
}  // namespace feedscope
