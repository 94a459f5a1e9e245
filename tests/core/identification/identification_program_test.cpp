#include "core/identification/identification_program.h"

#include <gmock/gmock.h>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

using testing::HasSubstr;

class IdentificationPrograms : public testing::TestWithParam<Dialect> {};

TEST_P(IdentificationPrograms, AreReadWithoutMessagesAndKeepToTheirRoom) {
  const IdentificationProgram made = identification_program({GetParam(), 160, units::from_mm_min(12000)});
  ReadOptions options;
  options.dialect = GetParam();
  const LoadedProgram read =
      load_program(std::make_shared<const SourceText>(SourceText("test.nc", made.text)), nullptr, options);
  for (const Diagnostic& diagnostic : read.program->diagnostics) {
    EXPECT_EQ(diagnostic.code, "chord-error") << format(diagnostic, "test.nc");
  }
  const Bounds& bounds = read.toolpath->bounds;
  EXPECT_GE(bounds.min.x(), -80);
  EXPECT_LE(bounds.max.x(), 80);
  EXPECT_GE(bounds.min.y(), -80);
  EXPECT_LE(bounds.max.y(), 80);
  EXPECT_GE(bounds.min.z(), 0);
  EXPECT_LE(bounds.max.z(), made.height);
  EXPECT_EQ(made.parts.size(), 7U);
  double fastest = 0;
  for (const Segment& segment : read.toolpath->segments) {
    fastest = std::max(fastest, segment.feed);
  }
  EXPECT_NEAR(units::to_mm_min(fastest), 12000, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Dialects, IdentificationPrograms,
                         testing::Values(Dialect::iso, Dialect::fanuc, Dialect::linuxcnc, Dialect::grbl,
                                         Dialect::sinumerik, Dialect::heidenhain));

/// All dialects say the same motion.
TEST(IdentificationProgram, IsOneMotionInEveryDialect) {
  std::vector<double> lengths;
  for (const Dialect dialect : {Dialect::iso, Dialect::sinumerik, Dialect::heidenhain}) {
    ReadOptions options;
    options.dialect = dialect;
    const IdentificationProgram made = identification_program({dialect, 200, 250});
    lengths.push_back(
        load_program(std::make_shared<const SourceText>(SourceText("t", made.text)), nullptr, options)
            .toolpath->length());
  }
  EXPECT_NEAR(lengths[0], lengths[1], 1e-6);
  EXPECT_NEAR(lengths[0], lengths[2], 1e-6);
}

/// Each time in a variable of its own, read after what was read ahead.
TEST(IdentificationProgram, LetsTheControlTakeTheTimeOfEachSection) {
  const IdentificationProgram fanuc = identification_program({Dialect::fanuc, 200, 250});
  EXPECT_EQ(fanuc.sections, 70U);
  EXPECT_THAT(fanuc.text, HasSubstr("G53\n#3001=0\n(SECTION 1 BEGINS)\n"));
  EXPECT_THAT(fanuc.text, HasSubstr("G4 X0.25\n(SECTION 70 ENDS)\nG53\n#170=#3001\n"));
  const IdentificationProgram sinumerik = identification_program({Dialect::sinumerik, 200, 250});
  EXPECT_THAT(sinumerik.text, HasSubstr("STOPRE\n$AC_TIMER[1]=0\n; SECTION 1 BEGINS\n"));
  EXPECT_THAT(sinumerik.text, HasSubstr("; SECTION 70 ENDS\nSTOPRE\nR70=$AC_TIMER[1]\n"));
  EXPECT_EQ(identification_program({Dialect::heidenhain, 200, 250}).sections, 70U);
}

TEST(IdentificationProgram, RefusesWhatNoMachineHas) {
  const auto refusal = [](const IdentificationProgramRequest& request) {
    try {
      identification_program(request);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("made");
  };
  EXPECT_THAT(refusal({Dialect::iso, 5, 100}), HasSubstr("size = 5 mm is out of bounds"));
  EXPECT_THAT(refusal({Dialect::iso, 200, 0}), HasSubstr("feed-max = 0 mm/min is out of bounds"));
  EXPECT_THAT(refusal({Dialect::heidenhain_iso, 200, 100}), HasSubstr("no test program for dialect"));
}

}  // namespace
}  // namespace feedscope
