#include "ui/report/sheet.h"

#include <gmock/gmock.h>

#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include "core/base/error.h"
#include "tests/ui/report/pdf_reading.h"
#include "tests/ui/report/recorded_text.h"
#include "tests/ui/report/report_fixture.h"
#include "ui/report/pictures.h"
#include "ui/report/scene_picture.h"
#include "ui/workbench/reading_faults.h"

namespace feedscope::ui {
namespace {

PictureRequest request_of(PictureFormat format, const QSizeF& size) {
  PictureRequest request;
  request.format = format;
  request.size = size;
  return request;
}

TEST(Sheet, OpensInEveryFormatLyingAndUpright) {
  const ReportInput input = test::two_runs();
  for (const QSizeF& size : {QSizeF(1123, 794), QSizeF(794, 1123)}) {
    const std::string png = sheet_file(input, request_of(PictureFormat::png, size));
    EXPECT_EQ(QImage::fromData(QByteArray::fromStdString(png)).size(), size.toSize());
    const std::string svg = sheet_file(input, request_of(PictureFormat::svg, size));
    EXPECT_TRUE(QSvgRenderer(QByteArray::fromStdString(svg)).isValid());
    const std::string pdf = sheet_file(input, request_of(PictureFormat::pdf, size));
    test::PdfReading reading(pdf);
    EXPECT_EQ(reading.page_count(), 1U);
    EXPECT_TRUE(reading.fonts_embedded());
  }
}

TEST(Sheet, TooSmallASizeIsAnErrorThatNamesTheLeast) {
  EXPECT_THAT(
      [] {
        sheet_file(test::two_runs(), request_of(PictureFormat::png, {600, 400}));
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("at least 880")));
}

TEST(Sheet, ItsTablesCallRunsAsItsPicturesDo) {
  const auto texts = [](const ReportInput& input) {
    test::RecordedText paper;
    QPainter painter(&paper);
    paint_sheet(painter, {1123, 794}, input, {});
    return paper.texts();
  };
  ReportInput input = test::two_runs();
  const QStringList both = texts(input);
  EXPECT_TRUE(both.contains("A"));
  EXPECT_TRUE(both.contains("B"));
  EXPECT_TRUE(both.contains("test.nc · Spinner MVC 850 · Siemens Sinumerik 840D · essid · A 0.01 mm"))
      << both.join('|').toStdString();
  input.runs.resize(1);
  EXPECT_FALSE(texts(input).contains("A"));
}

TEST(ScenePicture, ATransparentOneHasNothingBehindThePath) {
  const ReportInput input = test::two_runs();
  ScenePicture picture(input, 0, ThemeKind::light, true);
  const QImage image = picture.image({400, 300}, {});
  EXPECT_EQ(image.pixelColor(2, 298).alpha(), 0);
  EXPECT_EQ(image.pixelColor(398, 298).alpha(), 0);
  int opaque = 0;
  int between = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int alpha = image.pixelColor(x, y).alpha();
      opaque += alpha == 255 ? 1 : 0;
      between += alpha > 0 && alpha < 255 ? 1 : 0;
    }
  }
  EXPECT_GT(opaque, 500);
  EXPECT_GT(between, 100) << "edges are smooth";
}

TEST(ScenePicture, LooksTheSameInASharedWindowAfterAnotherPicture) {
  const ReportInput input = test::two_runs();
  const auto drawn = [&](ThemeKind theme, const QSizeF& size) {
    return ScenePicture(input, 0, theme).image(size, {});
  };
  const QSizeF size(320, 200);
  const QImage alone = drawn(ThemeKind::light, size);
  const SharedPictureWindow window;
  EXPECT_NE(drawn(ThemeKind::dark, {500, 300}).size(), alone.size());
  EXPECT_EQ(drawn(ThemeKind::light, size), alone);
  EXPECT_EQ(drawn(ThemeKind::light, size), alone);
}

TEST(ScenePicture, AnnotationsArePaintedOverTheViewAtEverySize) {
  ReportInput input = test::two_runs();
  PictureRequest request = request_of(PictureFormat::png, {600, 450});
  for (const double ratio : {1.0, 2.0}) {
    request.pixel_ratio = ratio;
    input.annotations.clear();
    const QImage plain = QImage::fromData(QByteArray::fromStdString(scene_file(input, request)));
    input.annotations = {test::note("{feed}")};
    const QImage noted = QImage::fromData(QByteArray::fromStdString(scene_file(input, request)));
    QRect changed;
    for (int y = 0; y < plain.height(); ++y) {
      for (int x = 0; x < plain.width(); ++x) {
        if (plain.pixel(x, y) != noted.pixel(x, y)) {
          changed |= QRect(x, y, 1, 1);
        }
      }
    }
    EXPECT_GT(changed.width(), 60 * ratio);
    EXPECT_LT(changed.width(), 200 * ratio);
    EXPECT_LT(changed.height(), 120 * ratio);
  }
}

TEST(ScenePicture, AnnotationsAreVectorsWhereTheFormatHasThem) {
  ReportInput input = test::two_runs();
  const PictureRequest request = request_of(PictureFormat::svg, {600, 450});
  const std::string plain = scene_file(input, request);
  input.annotations = {test::note("here")};
  EXPECT_GT(scene_file(input, request).size(), plain.size() + 300);
}

TEST(ScenePicture, RefusesMorePixelsThanCanBeDrawn) {
  const ReportInput input = test::two_runs();
  ScenePicture picture(input, 0, ThemeKind::light);
  EXPECT_THAT(
      [&] {
        picture.image({4000, 300}, {3, 1});
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("12000 x 900")));
}

/// The same runs of a program of which the reading says this.
ReportInput said(ReportInput input, std::vector<Severity> severities) {
  auto program = std::make_shared<Program>(*input.program().program);
  program->diagnostics.clear();
  for (const Severity severity : severities) {
    program->diagnostics.push_back({severity, 1, 1, "code", Message::as_written("something"), {}});
  }
  for (ReportRun& run : input.runs) {
    auto shown = std::make_shared<ShownRun>(*run.shown);
    shown->run.input.program = program;
    run.shown = std::move(shown);
  }
  return input;
}

TEST(Pictures, EveryOneCountsErrorsAndWarningsOfTheReadingAndNothingElse) {
  const ReportInput input = test::two_runs();
  const auto pictures = [&](const std::vector<Severity>& severities) {
    const ReportInput changed = said(input, severities);
    std::vector<std::string> all;
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg, PictureFormat::pdf}) {
      for (auto* const make : {scene_file, charts_file, sheet_file}) {
        all.push_back(make(changed, request_of(format, {1123, 794})));
      }
    }
    return all;
  };
  pictures({});  // the first ones of a process lay out fonts and charts anew
  const std::vector<std::string> clean = pictures({});
  const std::vector<std::string> informed = pictures({Severity::info, Severity::info});
  const std::vector<std::string> warned = pictures({Severity::warning});
  const std::vector<std::string> wrong = pictures({Severity::error});
  for (std::size_t i = 0; i < clean.size(); ++i) {
    EXPECT_TRUE(informed[i] == clean[i]) << i;
    EXPECT_TRUE(warned[i] != clean[i]) << i;
    EXPECT_TRUE(wrong[i] != clean[i]) << i;
    EXPECT_TRUE(wrong[i] != warned[i]) << i;
  }
}

TEST(ReadingFaults, AreCountedInWords) {
  const auto text = [](const std::vector<Severity>& severities) {
    return reading_faults_text(*said(test::two_runs(), severities).program().program).toStdString();
  };
  using enum Severity;
  EXPECT_EQ(text({}), "");
  EXPECT_EQ(text({info}), "");
  EXPECT_EQ(text({error}), "Program read with 1 error");
  EXPECT_EQ(text({warning, warning, info}), "Program read with 2 warnings");
  EXPECT_EQ(text({error, warning, error}), "Program read with 2 errors and 1 warning");
}

TEST(ReportRuns, AreNamedByWhatTellsThemApart) {
  const ReportInput input = test::two_runs();
  EXPECT_EQ(input.runs[0].name, "essid, 0.01 mm");
  EXPECT_EQ(input.runs[1].name, "essid, 0.05 mm");
  EXPECT_NE(input.runs[0].colour, input.runs[1].colour);
  const auto same = report_runs({input.runs[0].shown, input.runs[0].shown});
  EXPECT_NE(same[0].name, same[1].name);
  const LoadedProgram program =
      load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
  std::vector<std::shared_ptr<const ShownRun>> shown;
  for (const char* jerk : {"X.jerk=10", "X.jerk=20"}) {
    shown.push_back(make_shown(simulate_run(program, make_setup({"", "essid", 0.05, {jerk}}))));
  }
  const auto limits = report_runs(shown);
  EXPECT_EQ(limits[0].name, "essid, 0.05 mm, X Jerk 10 m/s³");
  EXPECT_EQ(limits[1].name, "essid, 0.05 mm, X Jerk 20 m/s³");
}

}  // namespace
}  // namespace feedscope::ui
