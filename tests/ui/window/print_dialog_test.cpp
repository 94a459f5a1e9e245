#include "ui/window/dialogs/print_dialog.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/error.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class PrintDialogTest : public testing::Test {
 protected:
  PrintDialogTest() {
    QFile program(folder.filePath("part.nc"));
    EXPECT_TRUE(program.open(QIODevice::WriteOnly));
    program.write(test::small_program.c_str());
    Session session;
    session.program = program.fileName().toStdString();
    session.runs.push_back({1, {}, run_colour(0), true, SetupState(make_setup({"", "essid", 0.02, {}}))});
    subject.session = session;
    subject.language = QStringLiteral("en");
  }

  static bool rests(PrintDialog& dialog) {
    return QTest::qWaitFor([&] { return !dialog.busy(); }, patience);
  }
  /// The bytes of the file that the dialog prints into.
  QByteArray printed(PrintDialog& dialog) const {
    const QString name = folder.filePath("printed.pdf");
    dialog.printer().setOutputFormat(QPrinter::PdfFormat);
    dialog.printer().setOutputFileName(name);
    dialog.print();
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }

  QTemporaryDir folder;
  PrintSubject subject;
};

TEST_F(PrintDialogTest, PrintsTheViewAsVectors) {
  PrintDialog dialog(subject, FEEDSCOPE_EXECUTABLE);
  ASSERT_TRUE(rests(dialog));
  ASSERT_EQ(dialog.pages().count(), 1) << dialog.state().toStdString();
  EXPECT_TRUE(dialog.pages().landscape());
  const QByteArray pdf = printed(dialog);
  EXPECT_TRUE(pdf.startsWith("%PDF"));
  EXPECT_FALSE(pdf.contains("/Subtype /Image")) << "the 3D view is shapes";
}

TEST_F(PrintDialogTest, OffersWhatThereIs) {
  EXPECT_EQ(PrintDialog(subject, FEEDSCOPE_EXECUTABLE).choice().count(), 4);
  const Lesson lesson = read_lesson(find_lesson("3"), "fr");
  subject.lesson = &lesson;
  PrintDialog dialog(subject, FEEDSCOPE_EXECUTABLE);
  ASSERT_EQ(dialog.choice().count(), 7);
  EXPECT_EQ(dialog.choice().currentIndex(), 4) << "the hand-out of the lesson that is open";
  ASSERT_TRUE(rests(dialog));
  EXPECT_GE(dialog.pages().count(), 2) << dialog.state().toStdString();
  EXPECT_FALSE(dialog.pages().landscape());
  EXPECT_EQ(dialog.pages().title().toStdString(), lesson.title);
}

TEST_F(PrintDialogTest, TheTableWithTheFocusComesFirst) {
  QTableWidget table(3, 2);
  table.setHorizontalHeaderLabels({"Value", "Time"});
  for (int row = 0; row < 3; ++row) {
    table.setItem(row, 0, new QTableWidgetItem(QString::number(row)));
    table.setItem(row, 1, new QTableWidgetItem("<b>"));
  }
  subject.tables = {{"Runs", &table, false}, {"Lesson", &table, true}};
  PrintDialog dialog(subject, FEEDSCOPE_EXECUTABLE);
  EXPECT_EQ(dialog.choice().currentText(), "Table: Lesson");
  EXPECT_EQ(dialog.pages().count(), 1);
  EXPECT_THAT(table_page("Runs", *table.model()).toStdString(), testing::HasSubstr("&lt;b&gt;"));
}

TEST_F(PrintDialogTest, PagesAreShownAsLargeAsOneLikes) {
  PrintDialog dialog(subject, FEEDSCOPE_EXECUTABLE);
  ASSERT_TRUE(rests(dialog));
  const QPrintPreviewWidget& preview = dialog.preview();
  EXPECT_EQ(preview.zoomMode(), QPrintPreviewWidget::FitInView);
  const double whole = preview.zoomFactor();
  dialog.zoom_actions()[2]->trigger();
  EXPECT_GT(preview.zoomFactor(), whole);
  dialog.zoom_actions()[3]->trigger();
  EXPECT_NEAR(preview.zoomFactor(), whole, 1e-9);
  dialog.zoom_actions()[1]->trigger();
  EXPECT_EQ(preview.zoomMode(), QPrintPreviewWidget::FitToWidth);
  dialog.zoom_actions()[0]->trigger();
  EXPECT_EQ(preview.zoomMode(), QPrintPreviewWidget::FitInView);
}

TEST_F(PrintDialogTest, SaysThatThereIsNothing) {
  PrintDialog dialog({}, FEEDSCOPE_EXECUTABLE);
  EXPECT_EQ(dialog.pages().count(), 0);
  EXPECT_THAT(dialog.state().toStdString(), testing::HasSubstr("open a program or a lesson first"));
}

TEST_F(PrintDialogTest, ReportsAreOfSeveralPages) {
  PrintDialog dialog(subject, FEEDSCOPE_EXECUTABLE);
  dialog.choice().setCurrentIndex(3);
  ASSERT_TRUE(rests(dialog));
  EXPECT_GT(dialog.pages().count(), 3) << dialog.state().toStdString();
}

/// Whatever the dots of the device: a preview, a printer.
TEST(RecordedPages, FillTheSheet) {
  RecordedPages pages("Title", {297, 210});
  constexpr QSizeF size(1122.5, 793.7);  // of A4 at 96 dots an inch
  pages.add(size, [&](QPainter& painter) {
    painter.fillRect(QRectF(QPointF(), size / 2), Qt::red);  // the upper left quarter
  });
  for (const double dots : {96.0, 300.0}) {
    QImage sheet(842, 595, QImage::Format_RGB32);
    sheet.fill(Qt::white);
    sheet.setDotsPerMeterX(static_cast<int>(dots / 0.0254));
    sheet.setDotsPerMeterY(static_cast<int>(dots / 0.0254));
    QPainter painter(&sheet);
    pages.draw(painter, 0, sheet.rect());
    painter.end();
    EXPECT_EQ(sheet.pixelColor(415, 290), QColor(Qt::red)) << dots;
    EXPECT_EQ(sheet.pixelColor(430, 290), QColor(Qt::white)) << dots;
    EXPECT_EQ(sheet.pixelColor(415, 305), QColor(Qt::white)) << dots;
  }
}

TEST(RecordedPages, AreReadBackAndNothingElseIs) {
  RecordedPages pages("Title", {297, 210});
  pages.add({100, 70}, [](QPainter& painter) { painter.drawLine(0, 0, 100, 70); });
  const QByteArray bytes = QByteArray::fromStdString(pages.bytes());
  const RecordedPages read = RecordedPages::from_bytes(bytes);
  EXPECT_EQ(read.count(), 1);
  EXPECT_EQ(read.title(), "Title");
  EXPECT_TRUE(read.landscape());
  EXPECT_THROW(RecordedPages::from_bytes("%PDF"), InputError);
  EXPECT_THROW(RecordedPages::from_bytes(bytes.left(bytes.size() - 10)), InputError);
}

}  // namespace
}  // namespace feedscope::ui
