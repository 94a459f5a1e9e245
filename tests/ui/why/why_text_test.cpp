#include "ui/why/why_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLocale>
#include <filesystem>
#include <set>

#include "tests/support/folders.h"
#include "tests/ui/locale_in_force.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class WhyTextTest : public testing::Test {
 protected:
  WhyTextTest() { QLocale::setDefault(QLocale::c()); }

  /// The explanation of the first instant of a sample with that cause.
  static Explanation explained(const std::string& sample, const std::string& model,
                               const std::string& machine, CauseKind kind) {
    SetupRequest request;
    request.model = model;
    request.machine = machine;
    const auto run = simulate_run(
        load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs" / sample),
        make_setup(request));
    for (int i = 0; i < 2000; ++i) {
      const State state = run.trajectory->state(run.trajectory->duration() * (i + 0.5) / 2000);
      if (state.cause.kind == kind) {
        return explain(run, state);
      }
    }
    ADD_FAILURE() << "never limited by that";
    return {};
  }
};

TEST_F(WhyTextTest, TapieCircleSaysRadiusJerkAndFormula) {
  const Explanation why =
      explained("tapie_circle_2_5.nc", "tapie", "mikron-ucp710", CauseKind::curvilinear_jerk);
  EXPECT_EQ(
      WhyText::sentence(why).toStdString(),
      "On the radius of 2.5 mm the control allows a curvilinear jerk of 10 m/s³, of which 60 % along the "
      "path.");
  EXPECT_EQ(WhyText::formula(why.reason).toStdString(),
            "V = (J<sub>curv</sub> r<sub>jct</sub> R<sup>2</sup>)<sup>1/3</sup><br/>"
            "= (10 m/s³ · 0.6 · (2.5 mm)<sup>2</sup>)<sup>1/3</sup><br/>= <b>2008 mm/min</b>");
  EXPECT_THAT(WhyText::source(why.reason).toStdString(), HasSubstr("Tapie 2007"));
}

TEST_F(WhyTextTest, BrakingSaysForWhatAndHowFar) {
  const Explanation why = explained("essid_table1.nc", "essid", "spinner-mvc850", CauseKind::ramp_down);
  const std::string sentence = WhyText::sentence(why).toStdString();
  EXPECT_THAT(sentence, HasSubstr("The tool brakes: in "));
  EXPECT_THAT(sentence, HasSubstr(QString::number(why.ahead->reason.line).toStdString()));
  EXPECT_THAT(WhyText::sentence(*why.ahead, why.state).toStdString(),
              HasSubstr("radial jerk may use 20 % of the jerk limit of axis X, 10 m/s³"));
}

TEST_F(WhyTextTest, EveryCauseHasANameAndASentenceOfItsOwn) {
  std::set<QString> names;
  std::set<QString> sentences;
  for (const Cause cause : all_causes()) {
    names.insert(WhyText::cause(cause));
    Explanation why;
    why.state.cause = why.reason.cause = cause;
    why.state.tangential_jerk = 1;
    EXPECT_FALSE(WhyText::sentence(why).isEmpty());
    EXPECT_FALSE(WhyText::sentence(why).contains('%')) << WhyText::sentence(why).toStdString();
    sentences.insert(WhyText::sentence(why));
  }
  EXPECT_EQ(names.size(), all_causes().size());
  EXPECT_GE(sentences.size(), 20U);
}

TEST_F(WhyTextTest, NumbersAreRoundedToWhatCounts) {
  EXPECT_EQ(WhyText::number(2.5, Dimension::length).toStdString(), "2.5 mm");
  EXPECT_EQ(WhyText::number(0.012, Dimension::time).toStdString(), "12 ms");
  EXPECT_EQ(WhyText::number(1.5, Dimension::time).toStdString(), "1.5 s");
  EXPECT_EQ(WhyText::number(15000, Dimension::jerk).toStdString(), "15 m/s³");
  EXPECT_EQ(WhyText::number(1e7, Dimension::jerk).toStdString(), "10000 m/s³");
  EXPECT_EQ(WhyText::number(0.80001, Dimension::number).toStdString(), "0.8");
  EXPECT_EQ(WhyText::speed(0).toStdString(), "0 mm/min");
  const test::LocaleInForce locale{QLocale(QLocale::French)};
  EXPECT_EQ(WhyText::number(2.5, Dimension::length).toStdString(), "2,5 mm");
}

TEST(WhyText, NothingIsZeroAndHasNoSign) {
  EXPECT_EQ(WhyText::speed(-6.2e-10), "0 mm/min");
  EXPECT_EQ(WhyText::speed(6.2e-10), "0 mm/min");
  EXPECT_EQ(WhyText::number(-1e-12, Dimension::length), "0 mm");
  EXPECT_EQ(WhyText::number(1e-15, Dimension::time), "0 ms");
  EXPECT_EQ(WhyText::number(-1e-9, Dimension::acceleration), "0 m/s²");
  EXPECT_EQ(WhyText::number(1e-5, Dimension::length), "1e-05 mm");
}

}  // namespace
}  // namespace feedscope::ui
