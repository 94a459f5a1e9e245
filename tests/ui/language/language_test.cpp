#include "ui/language/language.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/lessons/lesson_language.h"
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
    std::ranges::copy_if(spec.choices, std::back_inserter(texts), [](const std::string& choice) {
      return std::ranges::none_of(all_models(),
                                  [&](const ControlModel* model) { return model->info().id == choice; });
    });
  }
}

/// What the window shows of the core.
std::vector<std::string> shown_texts() {
  std::vector<std::string> texts;
  add(texts, axis_limit_specs());
  add(texts, rotary_axis_specs());
  for (const ControlModel* model : all_models()) {
    texts.push_back(model->info().title);
    texts.push_back(model->info().summary);
    add(texts, settings_of(*model));
  }
  return texts;
}

TEST(CoreTexts, EveryTextThatIsShownIsFrenchInAFrenchWindow) {
  QTranslator french;
  ASSERT_TRUE(french.load(":/translations/feedscope_fr"));
  QCoreApplication::installTranslator(&french);
  // Besides words that both languages share, names of releases and codes of programs.
  const std::set<std::string> the_same{"jerk", "Jerk", "2.9", "master", "G61", "G61.1", "G64"};
  for (const std::string& text : shown_texts()) {
    if (!the_same.contains(text)) {
      EXPECT_NE(core_text(text).toStdString(), text);
    }
  }
  for (const Cause cause : all_causes()) {
    EXPECT_NE(shown_cause(cause).toStdString(), cause_title(cause));
  }
  EXPECT_EQ(shown_cause({CauseKind::axis_jerk, 1}).toStdString(), "jerk de l’axe Y");
  QCoreApplication::removeTranslator(&french);
}

/// The core, which cannot read the translations, has its own words for lessons.
TEST(CoreTexts, CausesAndModelsAreCalledTheSameInLessons) {
  QTranslator french;
  ASSERT_TRUE(french.load(":/translations/feedscope_fr"));
  QCoreApplication::installTranslator(&french);
  const auto in_lessons = [](std::string_view text) {
    return QString::fromStdString(lesson_word(std::string(text), "fr")).replace(QChar(0x2019), '\'');
  };
  const auto in_window = [](std::string_view text) {
    return core_text(std::string(text)).replace(QChar(0x2019), '\'');
  };
  for (std::size_t i = 0; i < cause_kind_count; ++i) {
    const CauseInfo& info = info_of(static_cast<CauseKind>(i));
    EXPECT_EQ(in_lessons(info.title).toStdString(), in_window(info.title).toStdString());
    if (info.by_axis()) {
      EXPECT_EQ(in_lessons(info.axis_title).toStdString(), in_window(info.axis_title).toStdString());
    }
  }
  for (const ControlModel* model : all_models()) {
    const std::string title(model->info().title);
    EXPECT_EQ(in_lessons(title).toStdString(), in_window(title).toStdString());
  }
  QCoreApplication::removeTranslator(&french);
}

/// Context, text and comment of every message of a .ts file; `open`: those without a finished translation.
struct Messages {
  std::set<QString> all;
  std::set<QString> open;
};

Messages messages_of(const QString& name) {
  QFile file(name);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
  Messages messages;
  QXmlStreamReader xml(&file);
  QString context, source, comment;
  bool unfinished = false;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isStartElement() && xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (xml.isStartElement() && xml.name() == QLatin1String("source")) {
      source = xml.readElementText();
    } else if (xml.isStartElement() && xml.name() == QLatin1String("comment")) {
      comment = xml.readElementText();
    } else if (xml.isStartElement() && xml.name() == QLatin1String("translation")) {
      unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
      unfinished =
          xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed().isEmpty() || unfinished;
    } else if (xml.isEndElement() && xml.name() == QLatin1String("message")) {
      const QString message = QStringLiteral("%1 / %2 / %3").arg(context, source, std::exchange(comment, {}));
      messages.all.insert(message);
      if (unfinished) {
        messages.open.insert(message);
      }
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

std::string missing_text(const std::set<QString>& from, const std::set<QString>& in) {
  std::string text;
  for (const QString& message : from) {
    text += in.contains(message) ? "" : message.toStdString() + "\n";
  }
  return text;
}

/// What lupdate finds in the sources is what is translated, no more and no less.
TEST(Language, FrenchHasEveryTextOfTheWindow) {
  const QString shipped = FEEDSCOPE_SOURCE_DIR "/resources/translations/feedscope_fr.ts";
  const QTemporaryDir folder;
  const QString found = folder.filePath(QStringLiteral("found.ts"));
  QProcess lupdate;
  lupdate.setProcessChannelMode(QProcess::MergedChannels);
  lupdate.start(
      QStringLiteral(LUPDATE),
      {"-I", FEEDSCOPE_SOURCE_DIR, "-locations", "none", "-tr-function-alias", "QT_TRANSLATE_NOOP+=NC_",
       "-recursive", FEEDSCOPE_SOURCE_DIR "/core", FEEDSCOPE_SOURCE_DIR "/ui", "-ts", found});
  ASSERT_TRUE(lupdate.waitForFinished(120'000));
  ASSERT_EQ(lupdate.exitCode(), 0) << lupdate.readAll().toStdString();
  const Messages sources = messages_of(found);
  const Messages french = messages_of(shipped);
  EXPECT_GT(sources.all.size(), 500u);
  EXPECT_EQ(missing_text(sources.all, french.all), "") << "not in the translation";
  EXPECT_EQ(missing_text(french.all, sources.all), "") << "translated, but no longer in the sources";
  EXPECT_EQ(missing_text(french.open, {}), "") << "not translated";
}

/// A translation without one of the places would lose an argument.
TEST(Language, FrenchHasThePlacesOfEveryMessage) {
  std::vector<std::string> parts;
  for (char i = '0'; i <= '9'; ++i) {
    parts.push_back(std::string("<") + i + '>');
  }
  const auto places_in = [&](const QString& pattern) {
    const std::string text = filled(pattern.toStdString(), parts);
    std::string places;
    for (const std::string& part : parts) {
      places += text.find(part) == std::string::npos ? "" : part;
    }
    return places;
  };
  QTranslator french;
  ASSERT_TRUE(french.load(":/translations/feedscope_fr"));
  const QString of_core = QStringLiteral("core / ");
  std::size_t with_places = 0;
  for (const QString& message :
       messages_of(FEEDSCOPE_SOURCE_DIR "/resources/translations/feedscope_fr.ts").all) {
    const QString english = message.mid(of_core.size()).chopped(3);  // " / " and no comment
    if (message.startsWith(of_core)) {
      const std::string places = places_in(english);
      with_places += places.empty() ? 0 : 1;
      EXPECT_EQ(places_in(french.translate("core", english.toUtf8().constData())), places)
          << english.toStdString();
    }
  }
  EXPECT_GT(with_places, 500U);
}

TEST(Language, IsEnglishOrOneOfThoseThatAreShipped) {
  EXPECT_TRUE(languages().contains(chosen_language()));
  EXPECT_TRUE(languages().contains("fr"));
}

}  // namespace
}  // namespace feedscope::ui
