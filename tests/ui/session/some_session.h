#pragma once

#include "tests/ui/identification_fixture.h"
#include "ui/session/session.h"

namespace feedscope::ui {

/// Two runs, of which one is edited, and every kind of annotation; nothing as in a new session.
inline Session some_session(const std::filesystem::path& program) {
  Session session;
  session.program = program;
  session.program_hash = "0123abcd";
  session.reading.dialect = Dialect::fanuc;
  session.reading.skip_deleted_blocks = true;
  session.reading.repeat_limit = 12345;
  session.reading.call_depth = 5;
  session.reading.radii.set("7", 4.995);
  session.reading.radii.set("MILL 10,2", 5);
  session.reading.offsets.set("G55", Vec3(100, -0.125, 7));
  session.reading.offsets.set("G54.1 P3", Vec3(1, 2, 3));
  session.reading.tool_table = program.parent_path() / "tables" / "tool.t";
  session.reading.table_unit = 25.4;
  session.reading.wear_only = true;
  session.reading.simulate_cut_off = true;
  SetupState fine(make_setup({}));
  fine.set("contour_tolerance_mm", 0.0123);
  fine.set("program_tolerance", std::string("off"));
  fine.set("X.jerk", 7.5);
  session.runs = {{0, {}, QColor(0x00, 0x72, 0xb2), true, SetupState(make_setup({}))},
                  {0, "fine", QColor(0xd5, 0x5e, 0x00), false, fine}};
  session.current_run = 1;
  session.cursor = 0.25;
  session.error_bound = 0.02;
  session.scene.exaggeration = 100;
  session.scene.colouring = Colouring::cause;
  session.scene.stretch = {PathStretch::to_cursor, true};
  session.scene.on_machine = true;
  session.scenes = {ScenesMode::split, 0, 0.375, 1};
  session.charts.abscissa = Abscissa::path_length;
  session.charts.time = Interval{0.1, 0.4};
  session.charts.hidden_charts = {"jerk"};
  session.charts.shown_charts = {"rotary_jerk"};
  Engagement operation;
  operation.tool = "7";
  operation.lines = {{1, 20}};
  operation.diameter = 9.99;
  operation.teeth = 3;
  operation.radial_depth = 0.1 + 0.2;
  operation.axial_depth = 4;
  operation.material = "steel-c45";
  operation.max_force = 500;
  session.load.operations = {operation, operation};  // they overlap, as while someone edits them
  int segment = 0;
  for (const AnnotationKind kind : annotation_kinds) {
    Annotation annotation;
    annotation.kind = kind;
    annotation.place = {static_cast<std::uint32_t>(segment++), 0.1 + 0.2};
    annotation.until = has_two_places(kind) ? ProgrammedPlace{9, 1} : annotation.place;
    annotation.text = QStringLiteral("{feed}\nécart \"1\"");
    annotation.offset = {-12.5, 33};
    annotation.view = {1280, 800.5};
    annotation.colour = QColor(1, 2, 3);
    annotation.size = 14;
    session.annotations.push_back(annotation);
  }
  session.traces = {{0, program.parent_path() / "traces" / "first.csv", "time=1,x=2,y=3", "first part",
                     QColor(0, 0x9e, 0x73), false},
                    {0, program.parent_path() / "scope.xml", "", "scope.xml", QColor(1, 2, 3), true}};
  session.identification = test::some_identification(program.parent_path() / "traces" / "times.csv");
  session.lessons[{"04_small_circle", 2}] = {QStringLiteral("Les axes,\n\"eux-mêmes\""),
                                             "curvilinear_jerk_m_s3",
                                             "peak_feed_m_min_line_7",
                                             {{"5", 3.25, 1.594}, {"20", 2.5, {}}}};
  session.lessons[{"06_short_blocks", 0}] = {QStringLiteral("twice"), "", "", {}};
  session.lessons[{"06_short_blocks", prediction}].answer = QStringLiteral("Twice \"the\"\nfeed.");
  session.lessons[{"06_short_blocks", transfer}].answer = QStringLiteral("On my control it is 2 ms.");
  session.lessons_unlocked = true;
  session.layout = QByteArray("\x00\x01layout", 8);
  session.presentation = true;
  session.theme = ThemeKind::dark;
  session.program_font_size = 17;
  return session;
}

}  // namespace feedscope::ui
