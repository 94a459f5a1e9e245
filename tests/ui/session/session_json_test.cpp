#include "ui/session/session_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QJsonArray>

#include "core/base/error.h"
#include "tests/ui/session/some_session.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

const std::filesystem::path folder = "/parts/sessions";

Session read_back(const Session& session) {
  ReadSession read = read_session(to_json(session, folder), folder, shipped_machines());
  EXPECT_TRUE(read.notes.isEmpty()) << read.notes.join('\n').toStdString();
  return read.session;
}

void expect_same(const Session& a, const Session& b) {
  EXPECT_EQ(a.program, b.program);
  EXPECT_EQ(a.program_hash, b.program_hash);
  EXPECT_EQ(a.reading, b.reading);
  EXPECT_EQ(a.runs, b.runs);
  EXPECT_EQ(a.current_run, b.current_run);
  EXPECT_EQ(a.cursor, b.cursor);
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(a.scenes, b.scenes);
  EXPECT_EQ(a.charts, b.charts);
  EXPECT_EQ(a.load, b.load);
  EXPECT_EQ(a.annotations, b.annotations);
  EXPECT_EQ(a.traces, b.traces);
  EXPECT_EQ(a.layout, b.layout);
  EXPECT_EQ(a.presentation, b.presentation);
  EXPECT_EQ(a.theme, b.theme);
  EXPECT_EQ(a.program_font_size, b.program_font_size);
}

TEST(SessionJson, GivesBackEverything) {
  const Session session = test::some_session("/parts/pocket.nc");
  expect_same(read_back(session), session);
}

TEST(SessionJson, GivesBackANewSession) {
  Session session;
  session.program = "/parts/sessions/a.nc";
  session.runs = {{0, {}, QColor(Qt::red), true, SetupState(make_setup({}))}};
  expect_same(read_back(session), session);
}

TEST(SessionJson, NamesTheProgramRelativeToItself) {
  const QJsonObject json = to_json(test::some_session("/parts/pocket.nc"), folder);
  EXPECT_EQ(json["program"]["file"], QStringLiteral("../pocket.nc"));
  const Session moved = read_session(json, "/elsewhere/sessions", shipped_machines()).session;
  EXPECT_EQ(moved.program, std::filesystem::path("/elsewhere/pocket.nc"));
}

TEST(SessionJson, PathsThatAreNoTextAreKeptAsTheyWereRead) {
  QJsonObject json = to_json(test::some_session("/parts/pocket.nc"), folder);
  const QString half_a_character(QChar(0xd800));
  json["program"] = QJsonObject{{"file", half_a_character}};
  json["reading"] = QJsonObject{{"tool_table", half_a_character}};
  const Session session = read_session(json, folder, shipped_machines()).session;
  EXPECT_EQ(session.program.parent_path(), folder);
  expect_same(read_back(session), session);
}

TEST(SessionJson, ColoursHaveNoTransparencyAndEightBits) {
  for (const char* const colour : {"#80102030", "#111122223333", "transparent"}) {
    QJsonObject json = to_json(test::some_session("/a.nc"), folder);
    for (const char* const list : {"runs", "annotations"}) {
      QJsonArray items = json[list].toArray();
      QJsonObject first = items[0].toObject();
      first["colour"] = colour;
      items[0] = first;
      json[list] = items;
    }
    const Session session = read_session(json, folder, shipped_machines()).session;
    EXPECT_EQ(session.runs[0].colour.alpha(), 255) << colour;
    expect_same(read_back(session), session);
  }
}

TEST(SessionJson, RefusesReadingOptionsThatAreNone) {
  const auto message = [](const QJsonObject& reading) {
    QJsonObject json = to_json(test::some_session("/a.nc"), "/");
    json["reading"] = reading;
    try {
      read_session(json, "/", shipped_machines());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message({{"dialect", "fanux"}}), HasSubstr("fanuc"));
  EXPECT_THAT(message({{"call_depth", 1.5}}), HasSubstr("\"call_depth\" is 1.5"));
  EXPECT_THAT(message({{"repeat_limit", -1}}), HasSubstr("repeat_limit"));
  EXPECT_THAT(message({{"cutter_radii_mm", QJsonObject{{"7", "wide"}}}}), HasSubstr("\"7\" is wide"));
  for (const QJsonValue& zero :
       {QJsonValue("far"), QJsonValue(QJsonArray{1, 2}), QJsonValue(QJsonArray{1, 2, "3"})}) {
    EXPECT_THAT(message({{"work_offsets_mm", QJsonObject{{"G55", zero}}}}), HasSubstr("\"G55\""));
  }
  EXPECT_THAT(message({{"work_offsets_mm", QJsonObject{{"X", QJsonArray{1, 2, 3}}}}}), HasSubstr("\"X\""));
}

TEST(SessionJson, ShippedMachinesGoByTheirId) {
  const QJsonObject run = to_json(test::some_session("/a.nc"), "/")["runs"][0].toObject();
  EXPECT_EQ(run["machine"], QStringLiteral("spinner-mvc850"));
  EXPECT_FALSE(run.contains("machine_file"));
  EXPECT_TRUE(run["set"].toObject().isEmpty());
}

TEST(SessionJson, AMachineOfTheUsersTravelsWithTheSession) {
  Session session = test::some_session("/a.nc");
  feedscope::Setup own = make_setup({});
  own.machine.id = "workshop";
  own.machine.axes[1].jerk = 12345;
  session.runs[0].setup = SetupState(own);
  const Session back = read_back(session);
  EXPECT_EQ(back.runs[0].setup.file().machine, own.machine);
}

TEST(SessionJson, KeepsSettingsThatACommandLineSet) {
  Session session = test::some_session("/a.nc");
  SetupRequest request;
  request.tolerance = 0.042;
  session.runs[0].setup = SetupState(make_setup(request));
  EXPECT_EQ(read_back(session).runs[0].setup.setup(), make_setup(request));
}

/// Changes some_session as JSON and reads it.
struct Fault {
  const char* name;
  void (*spoil)(QJsonObject& json);
  const char* message;
};
void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

void set_in_first(QJsonObject& json, const QString& list, const QString& key, const QJsonValue& value) {
  QJsonArray items = json[list].toArray();
  QJsonObject first = items[0].toObject();
  first[key] = value;
  items[0] = first;
  json[list] = items;
}

class SessionFaults : public testing::TestWithParam<Fault> {};

TEST_P(SessionFaults, AreNamedWithThingAndValue) {
  QJsonObject json = to_json(test::some_session("/a.nc"), "/");
  GetParam().spoil(json);
  try {
    read_session(json, "/", shipped_machines());
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, SessionFaults,
    testing::Values(
        Fault{"format", [](QJsonObject& json) { json.remove("format"); }, "not a Feedscope session"},
        Fault{"newer", [](QJsonObject& json) { json["version"] = session_version + 1; }, "newer Feedscope"},
        Fault{"version", [](QJsonObject& json) { json["version"] = "x"; }, "\"version\""},
        Fault{"program", [](QJsonObject& json) { json.remove("program"); }, "names no program"},
        Fault{"runs", [](QJsonObject& json) { json["runs"] = QJsonArray(); }, "has no runs"},
        Fault{"machine", [](QJsonObject& json) { set_in_first(json, "runs", "machine", "spinner"); },
              "run 1: "},
        Fault{"model", [](QJsonObject& json) { set_in_first(json, "runs", "model", "esid"); }, "essid"},
        Fault{"setting",
              [](QJsonObject& json) {
                set_in_first(json, "runs", "set", QJsonObject{{"contour_tolerance_mm", -1}});
              },
              "run 1: "},
        Fault{"kind", [](QJsonObject& json) { set_in_first(json, "annotations", "kind", "cloud"); },
              "annotation 1: \"kind\" is \"cloud\""},
        Fault{"place",
              [](QJsonObject& json) {
                set_in_first(json, "annotations", "place", QJsonObject{{"segment", 1.5}});
              },
              "\"segment\" must be a whole number"},
        Fault{"share",
              [](QJsonObject& json) {
                set_in_first(json, "annotations", "place", QJsonObject{{"segment", 1}, {"share", 2}});
              },
              "\"share\" is 2"},
        Fault{"trace", [](QJsonObject& json) { set_in_first(json, "traces", "file", ""); },
              "trace 1 names no file"},
        Fault{"size", [](QJsonObject& json) { set_in_first(json, "annotations", "size_pt", 0); },
              "\"size_pt\" is 0"}));

TEST(SessionJson, UnknownKeysAreNotedWithTheNearestOne) {
  QJsonObject json = to_json(test::some_session("/a.nc"), "/");
  json["anotations"] = 1;
  set_in_first(json, "runs", "color", "#ffffff");
  const ReadSession read = read_session(json, "/", shipped_machines());
  const std::string notes = read.notes.join('\n').toStdString();
  EXPECT_EQ(read.notes.size(), 2);
  EXPECT_THAT(notes, HasSubstr("did you mean \"annotations\""));
  EXPECT_THAT(notes, HasSubstr("run 1 has an unknown key \"color\""));
  EXPECT_THAT(notes, HasSubstr("did you mean \"colour\""));
}

TEST(SessionJson, WhateverTheTypesNothingCrashes) {
  const QJsonObject good = to_json(test::some_session("/a.nc"), "/");
  const QJsonValue wrong[] = {QJsonValue(), 1e300, -1, "text", QJsonArray{1, "a"}, QJsonObject{{"a", 1}}};
  for (const QString& key : good.keys()) {
    for (const QJsonValue& value : wrong) {
      QJsonObject json = good;
      json[key] = value;
      try {
        const Session session = read_session(json, "/", shipped_machines()).session;
        EXPECT_LT(session.current_run, session.runs.size());
      } catch (const InputError& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
