#include "ui/page/page_texts.h"

#include <QCoreApplication>

#include "ui/language/shown_numbers.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {
namespace {

struct PageText {
  const char* context;
  const char* text;
};

/// Sentences and titles of other views come from there, so that page and program agree.
constexpr PageText texts_of_page[] = {
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "%1 lost here")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "%1 of %2")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "%1 places")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "%1: %2 of %3 (%4).")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "%1: %2, %3 less than %4, %5.")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "%1: %2, %3.")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "%1: the axes stand.")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "About this page")},
    {"KinematicCharts", QT_TRANSLATE_NOOP("KinematicCharts", "Acceleration")},
    {"KinematicCharts", QT_TRANSLATE_NOOP("KinematicCharts", "Acceleration of rotary axes")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "Actual contour error")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Against")},
    {"PageWords",
     QT_TRANSLATE_NOOP("PageWords", "All data is in this file; it asks no other one and no network.")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Charts over")},
    {"feedscope::ui::FilmDialog", QT_TRANSLATE_NOOP("feedscope::ui::FilmDialog", "Close")},
    {"feedscope::ui::SceneActions", QT_TRANSLATE_NOOP("feedscope::ui::SceneActions", "Colour")},
    {"ContourPlot", QT_TRANSLATE_NOOP("ContourPlot", "Contour error")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "Cycle time")},
    {"PageWords",
     QT_TRANSLATE_NOOP("PageWords",
                       "Drag: turn. Right button or two fingers: move. Wheel or pinch: zoom. Double click: "
                       "fit. In charts drag to move, wheel or pinch to zoom. Space plays, N and P go to the "
                       "next and previous worst place, F fits, arrows move the cursor.")},
    {"feedscope::ui::DecideView", QT_TRANSLATE_NOOP("feedscope::ui::DecideView", "Error %1")},
    {"KinematicCharts", QT_TRANSLATE_NOOP("KinematicCharts", "Feed")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Fit")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Fit the path into the picture (F)")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Front")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Go to the report below")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Iso")},
    {"KinematicCharts", QT_TRANSLATE_NOOP("KinematicCharts", "Jerk")},
    {"KinematicCharts", QT_TRANSLATE_NOOP("KinematicCharts", "Jerk of rotary axes")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Lens")},
    {"LensPicture", QT_TRANSLATE_NOOP("LensPicture", "Lens: line %1")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "Limited by")},
    {"Scene", QT_TRANSLATE_NOOP("Scene", "Limiting cause")},
    {"Annotations", QT_TRANSLATE_NOOP("Annotations", "Line %1")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords",
                                    "Long program, drawn coarser away from the listed places: path within "
                                    "%1, feed within %2 of the largest")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Look from here")},
    {"feedscope::ui::DecideView",
     QT_TRANSLATE_NOOP("feedscope::ui::DecideView", "Programmed: %1, at the programmed feed.")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Made with Feedscope %1. Simulated, not measured.")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Max. error")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Next worst place")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "No difference worth having: %1 takes %2, %3.")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "No other run can be taken.")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts", "No other run of the machine's own model can be taken.")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "No other run keeps the bound.")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts", "No other run with the machine's own model keeps the bound.")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Path")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Path within %1, feed within %2 of the largest")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Pause")},
    {"TimeRows", QT_TRANSLATE_NOOP("TimeRows", "Places that lose most")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Play")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Previous worst place")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "Program")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Programmed")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Rapids")},
    {"feedscope::ui::PrintDialog", QT_TRANSLATE_NOOP("feedscope::ui::PrintDialog", "Report")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Right")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "Run")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Show rapids")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Show the lens (L)")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Show the programmed path")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Speed")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts",
                       "The cycle times differ by less than 1 %. No run has a smaller error.")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts", "The fastest run. None within 1 % of it has a smaller error.")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts", "The smallest error within 1 % of the fastest run.")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts", "Runs with another model than their machine's own do not count.")},
    {"PageWords",
     QT_TRANSLATE_NOOP("PageWords", "This browser draws no 3D (WebGL 2): a picture of the report.")},
    {"TimeRows", QT_TRANSLATE_NOOP("TimeRows", "Time")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Time lost")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "Top")},
    {"KinematicCharts", QT_TRANSLATE_NOOP("KinematicCharts", "Velocity of rotary axes")},
    {"feedscope::ui::TimeView", QT_TRANSLATE_NOOP("feedscope::ui::TimeView", "Where the time goes")},
    {"feedscope::ui::WhyView", QT_TRANSLATE_NOOP("feedscope::ui::WhyView", "Why here?")},
    {"LensPicture", QT_TRANSLATE_NOOP("LensPicture", "across × %1")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "actual contour error %1")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "against %1")},
    {"feedscope::ui::DecisionChart", QT_TRANSLATE_NOOP("feedscope::ui::DecisionChart", "bound %1")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "contour error %1")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "no bound")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "over path")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "over time")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "place %1 of %2")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "refused")},
    {"PageWords", QT_TRANSLATE_NOOP("PageWords", "rotary axes within %1 of their limits")},
    {"DecisionTexts",
     QT_TRANSLATE_NOOP("DecisionTexts", "No run keeps a contour error of %1. The smallest is %2, with %3.")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "%1 %")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "%1, %2 less than programmed (%3); %4.")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "%1, as long as programmed; %2.")},
    {"DecisionTexts", QT_TRANSLATE_NOOP("DecisionTexts", "%1, of which %2 are lost (%3); %4.")},
    {"ReportWords", QT_TRANSLATE_NOOP("ReportWords", "Against %1")},
};

}  // namespace

QJsonObject page_texts() {
  QJsonObject texts;
  for (const PageText& one : texts_of_page) {
    texts[QString::fromUtf8(one.text)] = QCoreApplication::translate(one.context, one.text);
  }
  return texts;
}

QJsonObject page_units() {
  QJsonObject units;
  for (const auto& [name, dimension] : std::initializer_list<std::pair<const char*, Dimension>>{
           {"time", Dimension::time},
           {"length", Dimension::length},
           {"error", Dimension::error},
           {"feed", Dimension::feed},
           {"acceleration", Dimension::acceleration},
           {"jerk", Dimension::jerk},
           {"pace", Dimension::pace},
           {"turning", Dimension::turning},
           {"turning_acceleration", Dimension::turning_acceleration},
           {"turning_jerk", Dimension::turning_jerk}}) {
    const ShownUnit& unit = shown(dimension);
    units[QLatin1String(name)] =
        QJsonObject{{"text", unit_of(dimension)}, {"factor", unit.factor}, {"decimals", unit.decimals}};
  }
  return units;
}

}  // namespace feedscope::ui
