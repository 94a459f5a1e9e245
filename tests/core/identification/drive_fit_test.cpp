#include "core/identification/drive_fit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "core/analysis/run/run.h"
#include "core/drives/drive_response.h"
#include "core/identification/drive_record.h"
#include "core/identification/identification_program.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

using testing::HasSubstr;

/// How positions are recorded.
struct Recording {
  double period = 1e-3;  ///< [s]
  double noise = 0;      ///< of the actual position [mm]
  double step = 0;       ///< both are rounded to [mm]; 0: exact
  double delay = 0;      ///< of the actual position [s]
  double offset = 0;     ///< of the same [mm]
};

/// Runs the test program, and records set and actual positions of X.
class Recorder {
 public:
  explicit Recorder(const std::vector<std::string>& settings, const std::string& machine = "spinner-mvc850") {
    IdentificationProgramRequest request;
    request.size = 100;
    request.feed_max = 150;
    SetupRequest asked;
    asked.machine = machine;
    asked.assignments = settings;
    ReadOptions reading;
    reading.dialect = Dialect::iso;
    run_ = simulate_run(load_program(std::make_shared<const SourceText>(
                                         SourceText("test", identification_program(request).text)),
                                     nullptr, reading),
                        make_setup(asked));
  }

  Trace record(const AxisDrive& drive, const Recording& how, unsigned seed = 1) const {
    Machine machine = run_.setup.machine;
    machine.drives = AxisVector<AxisDrive>(machine.axes.axes());
    machine.drives[0] = drive;
    const DriveResponse response(run_.trajectory, machine);
    ActualWalk walk(response);
    ActualWalk late_walk(response);
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0, 1);
    const auto rounded = [&](double x) { return how.step > 0 ? how.step * std::round(x / how.step) : x; };
    Trace trace;
    trace.name = "t.csv";
    trace.period = how.period;
    const double duration = run_.summary.cycle_time;
    for (std::size_t i = 0; static_cast<double>(i) * how.period <= duration; ++i) {
      const double time = static_cast<double>(i) * how.period;
      const ActualMotion now = walk.at(time);
      const double set = now.position.x() + now.following_error.x();
      const double actual = late_walk.at(std::max(0.0, time - how.delay)).position.x();
      trace.time.push_back(time);
      trace.place[0].push_back(rounded(set));
      trace.actual[0].push_back(rounded(actual + how.noise * error(random)) + how.offset);
    }
    return trace;
  }

 private:
  Run run_;
};

AxisDrive drive_of(double gain, double feedforward, double lag) {
  AxisDrive drive;
  drive.gain = gain;
  drive.feedforward = feedforward;
  drive.lag = lag;
  return drive;
}

TEST(DriveFit, FindsGainFeedForwardAndLagOfRandomDrives) {
  const Recorder recorder({});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  const unsigned trials = test::random_cases(12U);
  std::size_t told = 0;
  for (unsigned trial = 0; trial < trials; ++trial) {
    const double gain = 20 * std::pow(6, share(random));
    const double feedforward = share(random) < 0.3 ? 0 : share(random);
    const double lag = share(random) < 0.2 ? 0 : 8e-3 * share(random);
    Recording how;
    how.period = std::array{1e-3, 2e-3, 4e-3}[trial % 3];
    how.noise = 3e-4;
    how.step = 1e-3;
    how.offset = 12;
    const Trace trace = recorder.record(drive_of(gain, feedforward, lag), how, trial);
    const DriveFit fit = fit_drive({&trace}, 'X', {});
    SCOPED_TRACE(fmt::format("Kv {:.4g} 1/s, f {:.4g}, Tv {:.4g} ms, each {} ms", gain, feedforward,
                             1e3 * lag, 1e3 * how.period));
    EXPECT_TRUE(fit.explains);
    EXPECT_LT(fit.left, 6e-4);  // rounding of both and noise: 0.41 um and the noise of 0.3 um
    const std::array<double, 3> truth{gain, feedforward, 1e3 * lag};
    for (std::size_t p = 0; p < truth.size(); ++p) {
      const IdentifiedParameter& one = fit.parameters[p];
      told += one.told ? 1 : 0;
      EXPECT_TRUE(one.told || !one.reason.empty());
      if (one.told) {
        EXPECT_NEAR(one.value, truth[p], std::max(p == 1 ? 0.01 : 0.02 * truth[p], one.uncertainty))
            << one.parameter.key << " +- " << one.uncertainty;
      }
    }
    // What is not told is such that the drive as a whole moves as the true one.
    const DriveRecord record({&trace}, 0, trace.size());
    EXPECT_LT(record.residuals(found_drive(fit, {})).norm(),
              1.05 * record.residuals(drive_of(gain, feedforward, lag)).norm());
  }
  EXPECT_GT(told, trials);  // delays that noise cannot tell from none leave some untold
}

TEST(DriveFit, TellsADriveInAMachineFilesUnits) {
  const Recorder recorder({});
  const Trace trace = recorder.record(drive_of(50, 0.9, 4e-3), {});
  const DriveFit fit = fit_drive({&trace}, 'X', {});
  const AxisDrive found = found_drive(fit, {});
  EXPECT_NEAR(*found.gain, 50, 0.01);
  EXPECT_NEAR(*found.feedforward, 0.9, 1e-4);
  EXPECT_NEAR(*found.lag, 4e-3, 1e-6);
  EXPECT_EQ(fit.parameters[0].parameter.key, "X.kv");
  EXPECT_EQ(fit.parameters[1].parameter.key, "X.velocity_feedforward");
  EXPECT_EQ(fit.parameters[2].parameter.key, "X.velocity_lag");
  EXPECT_EQ(fit.parameters[2].parameter.unit, "ms");
}

TEST(DriveFit, KeepsOtherValuesOfADrive) {
  const Recorder recorder({});
  const Trace trace = recorder.record(drive_of(50, 0.9, 4e-3), {});
  AxisDrive start = drive_of(20, 0, 0);
  start.backlash = 3e-3;
  const DriveFit fit = fit_drive({&trace}, 'X', start);
  EXPECT_EQ(fit.parameters[0].start, 20);
  EXPECT_EQ(found_drive(fit, start).backlash, 3e-3);
}

/// K/(s + K) is (Kv + f s)/(Tv s^2 + s + Kv) with Kv = (1 - f) K and Tv = f/K, whatever f is.
TEST(DriveFit, TellsNothingOfAGainAloneButUsesIt) {
  const Recorder recorder({});
  for (const double step : {0.0, 1e-3}) {
    Recording how;
    how.period = 4e-3;
    how.step = step;
    const Trace trace = recorder.record(drive_of(50, 0, 0), how);
    const DriveFit fit = fit_drive({&trace}, 'X', {});
    EXPECT_TRUE(fit.explains);
    EXPECT_TRUE(fit.of_first_order);
    EXPECT_EQ(fit.delay, 0);
    EXPECT_FALSE(fit.parameters[0].told);
    EXPECT_THAT(fit.parameters[0].reason, HasSubstr("look for the gain alone"));
    const AxisDrive found = found_drive(fit, {});
    EXPECT_NEAR(*found.gain, 50, 0.05);
    EXPECT_EQ(found.feedforward.value_or(0), 0);
    EXPECT_EQ(found.lag.value_or(0), 0);
  }
}

TEST(DriveFit, TellsAGainWhoseFeedForwardAndLagAreHeld) {
  const Recorder recorder({});
  Recording how;
  how.period = 4e-3;
  how.step = 1e-3;
  const Trace trace = recorder.record(drive_of(50, 0, 0), how);
  const DriveFit fit = fit_drive({&trace}, 'X', {}, {true, false, false});
  EXPECT_TRUE(fit.explains);
  EXPECT_TRUE(fit.parameters[0].told);
  EXPECT_NEAR(fit.parameters[0].value, 50, fit.parameters[0].uncertainty);
  EXPECT_LT(fit.parameters[0].uncertainty, 0.2);
  EXPECT_FALSE(fit.parameters[1].told);
  EXPECT_EQ(found_drive(fit, {}).feedforward.value_or(0), 0);
}

TEST(DriveFit, HoldsWhatTheMachineHas) {
  const Recorder recorder({});
  const Trace trace = recorder.record(drive_of(50, 0.9, 4e-3), {});
  const DriveFit gain = fit_drive({&trace}, 'X', drive_of(20, 0.9, 4e-3), {true, false, false});
  EXPECT_TRUE(gain.parameters[0].told);
  EXPECT_NEAR(gain.parameters[0].value, 50, 0.1);
  const DriveFit lag = fit_drive({&trace}, 'X', drive_of(50, 0.9, 0), {false, false, true});
  EXPECT_TRUE(lag.parameters[2].told);
  EXPECT_NEAR(lag.parameters[2].value, 4, 0.01);
  EXPECT_EQ(*found_drive(lag, drive_of(50, 0.9, 0)).gain, 50);
}

TEST(DriveFit, LooksForAllWhereWhatIsHeldContradictsTheRecord) {
  const Recorder recorder({});
  Recording how;
  how.step = 1e-3;
  const Trace trace = recorder.record(drive_of(50, 0.6, 4e-3), how);
  const DriveFit fit = fit_drive({&trace}, 'X', {}, {true, false, false});
  EXPECT_TRUE(fit.explains);
  EXPECT_EQ(fit.free, (FreeDriveNumbers{true, true, true}));
  EXPECT_NEAR(fit.parameters[1].value, 0.6, 0.01);
}

/// Set positions that run at constant velocity from sample to sample, answered by small steps.
Trace answered_in_lines(Trace trace, const AxisDrive& drive) {
  constexpr int substeps = 200;
  const double h = trace.period / substeps;
  double y = trace.place[0].front();
  double v = 0;
  for (std::size_t i = 0; i + 1 < trace.size(); ++i) {
    const double from = trace.place[0][i];
    const double velocity = (trace.place[0][i + 1] - from) / trace.period;
    trace.actual[0][i] = y;
    const auto acceleration = [&](double time, double place, double speed) {
      return (*drive.gain * (from + velocity * time - place) + *drive.feedforward * velocity - speed) /
             *drive.lag;
    };
    for (int k = 0; k < substeps; ++k) {  // the midpoint rule
      const double time = k * h;
      const double a = acceleration(time, y, v);
      const double middle = acceleration(time + h / 2, y + v * h / 2, v + a * h / 2);
      y += h * (v + a * h / 2);
      v += h * middle;
    }
  }
  trace.actual[0].back() = y;
  return trace;
}

TEST(DriveFit, CountsHowSetPositionsRunBetweenSamples) {
  const Recorder recorder({});
  for (const double period : {4e-3, 8e-3}) {
    Recording how;
    how.period = period;
    const AxisDrive drive = drive_of(60, 0.5, 5e-3);
    const Trace trace = answered_in_lines(recorder.record(drive, how), drive);
    const DriveFit fit = fit_drive({&trace}, 'X', {});
    EXPECT_TRUE(fit.explains);
    const std::array truth{60.0, 0.5, 5.0};
    for (std::size_t p = 0; p < truth.size(); ++p) {
      EXPECT_TRUE(fit.parameters[p].told) << fit.parameters[p].parameter.key;
      EXPECT_NEAR(fit.parameters[p].value, truth[p], fit.parameters[p].uncertainty);
    }
  }
}

TEST(DriveFit, CopesWithJitterAndGaps) {
  const Recorder recorder({});
  Trace trace = recorder.record(drive_of(60, 0.5, 3e-3), {});
  Trace part;
  part.period = trace.period;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(0, 9);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const bool lost = (i > 9000 && i < 9800) || (i > 30000 && i < 34000);
    if (!lost && any(random) > 0) {  // every tenth sample is missing, two stretches altogether
      part.time.push_back(trace.time[i]);
      part.place[0].push_back(trace.place[0][i]);
      part.actual[0].push_back(trace.actual[0][i]);
    }
  }
  part.period = 1.5e-3;
  const DriveFit fit = fit_drive({&part}, 'X', {});
  ASSERT_TRUE(fit.explains);
  EXPECT_NEAR(fit.parameters[0].value, 60, 0.6);
  EXPECT_NEAR(fit.parameters[1].value, 0.5, 0.01);
  EXPECT_NEAR(fit.parameters[2].value, 3, 0.1);
}

/// Nine periods of the slower trace are many samples of the faster one.
TEST(DriveRecord, ShiftsTracesOfTwoRatesByOneDelay) {
  const Recorder recorder({});
  const AxisDrive drive = drive_of(60, 0.5, 3e-3);
  Recording how;
  how.delay = 0.036;
  const Trace fast = recorder.record(drive, how);
  how.period = 4e-3;
  const Trace slow = recorder.record(drive, how);
  const DriveRecord record({&fast, &slow}, 0, fast.size() + slow.size());
  EXPECT_GT(record.size(), fast.size());
  const double samples = std::sqrt(static_cast<double>(record.size()));
  EXPECT_LT(record.residuals(drive, how.delay).norm() / samples, 2e-4);
  EXPECT_GT(record.residuals(drive, 0).norm() / samples, 0.1);
  EXPECT_GT(record.residuals(drive, -how.delay).norm() / samples, 0.2);
}

TEST(DriveFit, TakesEvenlySpreadPartsOfLongTraces) {
  const Recorder recorder({});
  const Trace trace = recorder.record(drive_of(60, 0.5, 3e-3), {2e-4});
  EXPECT_GT(trace.size(), 400'000);
  const DriveFit fit = fit_drive({&trace}, 'X', {});
  EXPECT_LT(fit.samples, 450'000);
  EXPECT_NEAR(fit.parameters[0].value, 60, 0.1);
}

TEST(DriveFit, TellsNothingOfAnAxisThatStands) {
  Trace trace;
  trace.period = 1e-3;
  for (int i = 0; i < 5000; ++i) {
    trace.time.push_back(1e-3 * i);
    trace.place[1].push_back(7);
    trace.actual[1].push_back(7.001);
  }
  const DriveFit fit = fit_drive({&trace}, 'Y', drive_of(40, 0, 0));
  for (const IdentifiedParameter& one : fit.parameters) {
    EXPECT_FALSE(one.told);
    EXPECT_THAT(one.reason, HasSubstr("hardly moves"));
  }
  EXPECT_EQ(found_drive(fit, drive_of(40, 0, 0)), drive_of(40, 0, 0));
  EXPECT_THAT(fit_drive({&trace}, 'X', {}).parameters[0].reason, HasSubstr("No trace has both"));
}

TEST(DriveFit, TellsNothingOfAnAxisThatFollowsExactly) {
  const Recorder recorder({});
  Recording noisy;
  noisy.noise = 5e-4;
  noisy.step = 1e-3;
  for (const Recording& how : {noisy, Recording()}) {
    Trace trace = recorder.record({}, how);
    if (how.noise == 0) {
      trace.actual = trace.place;
    }
    const DriveFit fit = fit_drive({&trace}, 'X', {});
    EXPECT_FALSE(fit.explains);
    EXPECT_THAT(fit.parameters[0].reason, HasSubstr("do not differ by more than noise"));
  }
}

TEST(DriveFit, TellsNothingWhereFrictionMakesTheFollowingError) {
  const Recorder recorder({});
  AxisDrive drive = drive_of(80, 1, 0);
  drive.friction_spike = 0.03;
  drive.friction_time = 0.1;
  const Trace trace = recorder.record(drive, {});
  const DriveFit fit = fit_drive({&trace}, 'X', {});
  EXPECT_FALSE(fit.explains);
  EXPECT_GT(fit.left, 1e-3);
  EXPECT_THAT(fit.parameters[0].reason, HasSubstr("more than a third"));
}

/// Another drive without a delay moves nearly alike: which of them it is cannot be told.
TEST(DriveFit, TellsNoGainWherePositionsWereNotRecordedAtTheSameTime) {
  const Recorder recorder({});
  Recording how;
  how.delay = 4e-3;
  how.period = 2e-3;
  const Trace trace = recorder.record(drive_of(50, 0.6, 4e-3), how);
  const DriveFit fit = fit_drive({&trace}, 'X', {});
  EXPECT_FALSE(fit.parameters[0].told);
  EXPECT_FALSE(fit.parameters[2].told);
  EXPECT_FALSE(fit.parameters[0].reason.empty());
}

TEST(DriveFit, WithOneAxisLateAreNotToldOfTheOthersEither) {
  const Recorder recorder({});
  const Trace trace = recorder.record(drive_of(60, 0.5, 3e-3), {});
  std::vector<DriveFit> fits{fit_drive({&trace}, 'X', {})};
  distrust_delayed(fits);
  EXPECT_TRUE(fits.front().explains);
  fits.emplace_back();
  fits.back().delay = 2e-3;
  distrust_delayed(fits);
  EXPECT_FALSE(fits.front().explains);
  EXPECT_EQ(fits.front().delay, 2e-3);
  EXPECT_FALSE(fits.front().parameters[0].told);
  EXPECT_EQ(found_drive(fits.front(), {}), AxisDrive());
}

TEST(DriveFit, NamesTheAxesWithSetAndActualPositions) {
  Trace trace;
  trace.place[0] = trace.place[1] = {1, 2};
  trace.actual[1] = {1, 2};
  Trace other;
  other.place[2] = other.actual[2] = {1, 2};
  EXPECT_EQ(axes_with_drives({&trace}), "Y");
  EXPECT_EQ(axes_with_drives({&trace, &other}), "YZ");
}

}  // namespace
}  // namespace feedscope
