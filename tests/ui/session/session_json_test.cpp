#include "ui/session/session_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QJsonArray>
#include <functional>

#include "core/base/error.h"
#include "tests/ui/session/some_session.h"
#include "ui/session/identification_json.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

const std::filesystem::path folder = "/parts/sessions";

Session read_back(const Session& session) {
  ReadSession read = read_session(to_json(session, folder), folder, shipped_machines());
  EXPECT_TRUE(read.notes.isEmpty()) << read.notes.join('\n').toStdString();
  return read.session;
}

void set_in_first(QJsonObject& json, const QString& list, const QString& key, const QJsonValue& value) {
  QJsonArray items = json[list].toArray();
  QJsonObject first = items[0].toObject();
  first[key] = value;
  items[0] = first;
  json[list] = items;
}

void expect_same(const Session& a, const Session& b) {
  EXPECT_EQ(a.program, b.program);
  EXPECT_EQ(a.program_hash, b.program_hash);
  EXPECT_EQ(a.reading, b.reading);
  EXPECT_EQ(a.runs, b.runs);
  EXPECT_EQ(a.current_run, b.current_run);
  EXPECT_EQ(a.cursor, b.cursor);
  EXPECT_EQ(a.error_bound, b.error_bound);
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(a.scenes, b.scenes);
  EXPECT_EQ(a.charts, b.charts);
  EXPECT_EQ(a.load, b.load);
  EXPECT_EQ(a.annotations, b.annotations);
  EXPECT_EQ(a.traces, b.traces);
  EXPECT_EQ(to_json(a.identification, folder, shipped_machines()),
            to_json(b.identification, folder, shipped_machines()));
  EXPECT_EQ(a.layout, b.layout);
  EXPECT_EQ(a.presentation, b.presentation);
  EXPECT_EQ(a.theme, b.theme);
  EXPECT_EQ(a.program_font_size, b.program_font_size);
}

TEST(SessionJson, GivesBackEverything) {
  const Session session = some_session("/parts/pocket.nc");
  expect_same(read_back(session), session);
}

TEST(SessionJson, GivesBackANewSession) {
  Session session;
  session.program = "/parts/sessions/a.nc";
  session.runs = {{0, {}, QColor(Qt::red), true, SetupState(make_setup({}))}};
  expect_same(read_back(session), session);
}

TEST(SessionJson, NamesTheProgramRelativeToItself) {
  const QJsonObject json = to_json(some_session("/parts/pocket.nc"), folder);
  EXPECT_EQ(json["program"]["file"], QStringLiteral("../pocket.nc"));
  const Session moved = read_session(json, "/elsewhere/sessions", shipped_machines()).session;
  EXPECT_EQ(moved.program, std::filesystem::path("/elsewhere/pocket.nc"));
}

TEST(SessionJson, PathsThatAreNoTextAreKeptAsTheyWereRead) {
  QJsonObject json = to_json(some_session("/parts/pocket.nc"), folder);
  const QString half_a_character(QChar(0xd800));
  json["program"] = QJsonObject{{"file", half_a_character}};
  json["reading"] = QJsonObject{{"tool_table", half_a_character}};
  const Session session = read_session(json, folder, shipped_machines()).session;
  EXPECT_EQ(session.program.parent_path(), folder);
  expect_same(read_back(session), session);
}

TEST(SessionJson, ColoursHaveNoTransparencyAndEightBits) {
  for (const char* const colour : {"#80102030", "#111122223333", "transparent"}) {
    QJsonObject json = to_json(some_session("/a.nc"), folder);
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

TEST(SessionJson, WhatWasIdentifiedComesBackWithItsMachines) {
  const Session session = some_session("/parts/pocket.nc");
  const IdentificationState read = read_back(session).identification;
  EXPECT_EQ(read.unused_traces, std::vector<std::size_t>{1});
  EXPECT_EQ(read.choice, session.identification.choice);
  ASSERT_EQ(read.tables.size(), 1U);
  EXPECT_FALSE(read.tables[0].used);
  EXPECT_EQ(read.tables[0].table->name, "/parts/traces/times.csv");
  ASSERT_EQ(read.tables[0].table->times.size(), 3U);
  EXPECT_EQ(read.tables[0].table->times[2].section, "4-7");
  EXPECT_EQ(read.tables[0].table->times[2].seconds, 1.234);
  EXPECT_EQ(read.tables[0].table->times[2].resolution, 0.001);
  EXPECT_EQ(read.tables[0].table->times[2].row, 5U);
  ASSERT_NE(read.result.outcome, nullptr);
  EXPECT_EQ(read.result.chosen, 1U);
  EXPECT_TRUE(read.result.stale);
  const IdentificationOutcome& saved = *session.identification.result.outcome;
  const IdentificationOutcome& outcome = *read.result.outcome;
  EXPECT_EQ(outcome.date, "2026-11-27");
  EXPECT_EQ(outcome.program, saved.program);
  EXPECT_EQ(outcome.recordings, saved.recordings);
  EXPECT_EQ(outcome.unfitted, saved.unfitted);
  ASSERT_EQ(outcome.models.size(), 2U);
  const Identification& best = outcome.models[0];
  EXPECT_EQ(best.setup, saved.models[0].setup) << "with the source of the number that was found";
  EXPECT_TRUE(best.explains);
  EXPECT_EQ(best.residual, 1.25);
  EXPECT_EQ(best.feed_error, 0.0123);
  EXPECT_EQ(best.simulations, 321U);
  EXPECT_TRUE(best.parameters[0].told);
  EXPECT_EQ(best.parameters[0].value, 1.30021);
  EXPECT_EQ(best.parameters[0].uncertainty, 0.0123);
  EXPECT_FALSE(best.parameters[1].told);
  EXPECT_EQ(best.parameters[1].at_least, 0.5);
  EXPECT_EQ(best.parameters[1].told_by, "SINGLE MOVES OF Z");
  ASSERT_EQ(best.drives.size(), 1U);
  EXPECT_EQ(best.drives[0].axis, 'Y');
  EXPECT_EQ(best.drives[0].samples, 4000U);
  EXPECT_EQ(best.drives[0].following_error, 0.0412);
  EXPECT_EQ(best.drives[0].left, 0.00041);
  EXPECT_TRUE(best.drives[0].explains);
  EXPECT_DOUBLE_EQ(best.agreements[0].simulated_time, 4.002);
  EXPECT_DOUBLE_EQ(best.agreements[0].feed_rms, 1.5);
  ASSERT_EQ(best.agreements[0].cells.size(), 4U);
  EXPECT_EQ(best.agreements[0].cells[3].simulated_time, 1.0005);
  ASSERT_EQ(best.sections[1].size(), 4U);
  EXPECT_EQ(best.sections[1][3].section, "4-7");
}

/// A curve of a page's width: what is kept does not grow with the recording.
TEST(SessionJson, OfALongRecordingAtMost200StretchesAreKept) {
  Session session = some_session("/a.nc");
  auto outcome = std::make_shared<IdentificationOutcome>(*session.identification.result.outcome);
  Agreement& agreement = outcome->models[0].agreements[0];
  agreement.cells.clear();
  for (int i = 0; i < 1501; ++i) {
    agreement.cells.push_back({0, 0, 0.25, i < 700 ? 0.25 : 0.5});
  }
  session.identification.result.outcome = outcome;
  const auto read = read_back(session).identification.result.outcome;
  const std::vector<AgreementCell>& cells = read->models[0].agreements[0].cells;
  EXPECT_LE(cells.size(), 200U);
  double measured = 0;
  double simulated = 0;
  for (const AgreementCell& cell : cells) {
    measured += cell.measured_time;
    simulated += cell.simulated_time;
  }
  EXPECT_DOUBLE_EQ(measured, 1501 * 0.25);
  EXPECT_DOUBLE_EQ(simulated, 700 * 0.25 + 801 * 0.5);
}

/// The rest of the session is worth more than a result that can be found again.
TEST(SessionJson, AResultThatCannotBeUsedIsOmittedWithANote) {
  const QJsonObject good = to_json(some_session("/a.nc"), "/");
  const auto note_of = [&](const std::function<void(QJsonObject&)>& spoil) {
    QJsonObject json = good;
    QJsonObject identification = json["identification"].toObject();
    QJsonObject result = identification["result"].toObject();
    spoil(result);
    identification["result"] = result;
    json["identification"] = identification;
    const ReadSession read = read_session(json, "/", shipped_machines());
    EXPECT_EQ(read.session.identification.result.outcome, nullptr);
    EXPECT_EQ(read.session.identification.tables.size(), 1U);
    return read.notes.join('\n').toStdString();
  };
  EXPECT_THAT(
      note_of([](QJsonObject& result) { result["models"] = QJsonArray(); }),
      HasSubstr("what was identified is omitted: \"result\" of \"identification\" has no \"models\""));
  EXPECT_THAT(note_of([](QJsonObject& result) { result["recordings"] = QJsonArray{QJsonObject()}; }),
              HasSubstr("model 1 has 2 \"agreements\" for 1 recordings"));
  EXPECT_THAT(note_of([](QJsonObject& result) {
                set_in_first(result, "models", "drives", QJsonArray{QJsonObject{{"axis", "A"}}});
              }),
              HasSubstr("\"axis\" is \"A\"; it must be X, Y or Z"));
  EXPECT_THAT(note_of([](QJsonObject& result) { set_in_first(result, "models", "model", "linuxcnk"); }),
              HasSubstr("model 1: "));
}

TEST(SessionJson, SectionTimesThatAreNoneAreOmittedWithANote) {
  QJsonObject json = to_json(some_session("/a.nc"), "/");
  QJsonObject identification = json["identification"].toObject();
  set_in_first(identification, "section_times", "resolution_s", 0);
  json["identification"] = identification;
  const ReadSession read = read_session(json, "/", shipped_machines());
  EXPECT_TRUE(read.session.identification.tables.empty());
  EXPECT_THAT(read.notes.join('\n').toStdString(),
              HasSubstr("section times \"traces/times.csv\" are omitted"));
}

TEST(SessionJson, RefusesReadingOptionsThatAreNone) {
  const auto message = [](const QJsonObject& reading) {
    QJsonObject json = to_json(some_session("/a.nc"), "/");
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
  const QJsonObject run = to_json(some_session("/a.nc"), "/")["runs"][0].toObject();
  EXPECT_EQ(run["machine"], QStringLiteral("spinner-mvc850"));
  EXPECT_FALSE(run.contains("machine_file"));
  EXPECT_TRUE(run["set"].toObject().isEmpty());
}

TEST(SessionJson, AMachineOfTheUsersTravelsWithTheSession) {
  Session session = some_session("/a.nc");
  feedscope::Setup own = make_setup({});
  own.machine.id = "workshop";
  own.machine.axes[1].jerk = 12345;
  session.runs[0].setup = SetupState(own);
  const Session back = read_back(session);
  EXPECT_EQ(back.runs[0].setup.file().machine, own.machine);
}

TEST(SessionJson, KeepsSettingsThatACommandLineSet) {
  Session session = some_session("/a.nc");
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

class SessionFaults : public testing::TestWithParam<Fault> {};

TEST_P(SessionFaults, AreNamedWithThingAndValue) {
  QJsonObject json = to_json(some_session("/a.nc"), "/");
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
  QJsonObject json = to_json(some_session("/a.nc"), "/");
  json["anotations"] = 1;
  set_in_first(json, "runs", "color", "#ffffff");
  const ReadSession read = read_session(json, "/", shipped_machines());
  const std::string notes = read.notes.join('\n').toStdString();
  EXPECT_EQ(read.notes.size(), 2);
  EXPECT_THAT(notes, HasSubstr("did you mean \"annotations\""));
  EXPECT_THAT(notes, HasSubstr("run 1 has an unknown key \"color\""));
  EXPECT_THAT(notes, HasSubstr("did you mean \"colour\""));
}

TEST(SessionJson, WhateverTheTypesInTheIdentificationNothingCrashes) {
  const QJsonObject good = to_json(some_session("/a.nc"), "/");
  const QJsonObject identification = good["identification"].toObject();
  const QJsonObject result = identification["result"].toObject();
  const QJsonValue wrong[] = {QJsonValue(), 1e300, -1, "text", QJsonArray{1, "a"}, QJsonObject{{"a", 1}}};
  const auto read = [&](const QJsonObject& spoiled) {
    QJsonObject json = good;
    json["identification"] = spoiled;
    const Session session = read_session(json, "/", shipped_machines()).session;
    const IdentificationResult& found = session.identification.result;
    EXPECT_TRUE(found.outcome == nullptr || found.chosen < found.outcome->models.size());
  };
  for (const QJsonValue& value : wrong) {
    for (const QString& key : identification.keys()) {
      QJsonObject spoiled = identification;
      spoiled[key] = value;
      read(spoiled);
    }
    for (const QString& key : result.keys()) {
      QJsonObject spoiled_result = result;
      spoiled_result[key] = value;
      QJsonObject spoiled = identification;
      spoiled["result"] = spoiled_result;
      read(spoiled);
    }
  }
}

/// A residual of null for one of 0 would say that the model explains everything.
TEST(SessionJson, ANumberOfAResultThatIsNoneDoesNotPassForZero) {
  for (const char* key : {"residual", "feed_error"}) {
    QJsonObject json = to_json(some_session("/a.nc"), "/");
    QJsonObject identification = json["identification"].toObject();
    QJsonObject result = identification["result"].toObject();
    QJsonArray models = result["models"].toArray();
    QJsonObject model = models[0].toObject();
    ASSERT_TRUE(model[key].isDouble()) << key;
    model[key] = QJsonValue();
    models[0] = model;
    result["models"] = models;
    identification["result"] = result;
    json["identification"] = identification;
    const ReadSession read = read_session(json, "/", shipped_machines());
    EXPECT_EQ(read.session.identification.result.outcome, nullptr) << key;
    EXPECT_THAT(read.notes.join("\n").toStdString(), HasSubstr(std::string("what was identified is omitted")))
        << key;
    EXPECT_THAT(read.notes.join("\n").toStdString(), HasSubstr(std::string(key) + "\" is not a number"));
  }
}

TEST(SessionJson, WhateverTheTypesNothingCrashes) {
  const QJsonObject good = to_json(some_session("/a.nc"), "/");
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
