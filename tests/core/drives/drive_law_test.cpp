#include "core/drives/drive_course.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "core/base/error.h"

namespace feedscope {
namespace {

AxisDrive drive(double gain, double feedforward, double lag) {
  AxisDrive drive;
  drive.gain = gain;
  drive.feedforward = feedforward;
  drive.lag = lag;
  return drive;
}

SetCourse course(std::initializer_list<double> derivatives, double duration) {
  SetCourse set;
  std::copy(derivatives.begin(), derivatives.end(), set.derivative.begin());
  set.duration = duration;
  return set;
}

/// Following error where `set` ends, after it has gone on for so long that nothing is left of the start.
double settled_error(const AxisDrive& axis, const SetCourse& set) {
  const DriveLaw law(axis, 'X');
  return -DriveCourse(law, set, {}).at_end().offset;
}

/// Of Tv y'' + y' + Kv y = Kv x + f x' in many small steps (Runge and Kutta), y from the start of the course.
MotorMotion integrated(const AxisDrive& axis, const SetCourse& set, MotorMotion at, double until) {
  const double kv = *axis.gain;
  const double f = *axis.feedforward;
  const double lag = *axis.lag;
  constexpr int steps = 20000;
  const double h = until / steps;
  const auto slope = [&](double t, const MotorMotion& y) {
    const double input = kv * set.travel(t) + f * set.velocity(t);
    return MotorMotion{y.velocity, (input - y.velocity - kv * y.offset) / lag};
  };
  const auto ahead = [](const MotorMotion& y, const MotorMotion& k, double step) {
    return MotorMotion{y.offset + step * k.offset, y.velocity + step * k.velocity};
  };
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const MotorMotion a = slope(t, at);
    const MotorMotion b = slope(t + h / 2, ahead(at, a, h / 2));
    const MotorMotion c = slope(t + h / 2, ahead(at, b, h / 2));
    const MotorMotion d = slope(t + h, ahead(at, c, h));
    at.offset += h / 6 * (a.offset + 2 * b.offset + 2 * c.offset + d.offset);
    at.velocity += h / 6 * (a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity);
  }
  return at;
}

// In steady motion y = x - e with e constant: Kv e = (1 - f) v.
TEST(DriveLaw, FollowingErrorOfConstantVelocityIsItsUnfedShareOverTheGain) {
  const SetCourse steady = course({0, 100}, 5);
  for (const double f : {0.0, 0.25, 0.9, 1.0}) {
    for (const double lag : {0.0, 0.002, 0.006, 0.05}) {
      EXPECT_NEAR(settled_error(drive(60, f, lag), steady), (1 - f) * 100 / 60, 1e-11) << f << ' ' << lag;
    }
  }
}

// With f = 1 and e constant: Tv y'' + y' + Kv y = Kv x + x' gives Tv a = Kv e.
TEST(DriveLaw, FollowingErrorOfConstantAccelerationIsTheLagOverTheGain) {
  const SetCourse steady = course({0, 0, 500}, 3);
  EXPECT_NEAR(settled_error(drive(60, 1, 0.006), steady), 0.006 / 60 * 500, 1e-10);
  EXPECT_NEAR(settled_error(drive(33, 1, 0.003), steady), 0.003 / 33 * 500, 1e-10);
}

// The transfer function at s = iw: |y| = R |(Kv + f i w)/(Kv - Tv w^2 + i w)|.
TEST(DriveLaw, SineIsAnsweredWithTheGainOfTheTransferFunction) {
  constexpr double amplitude = 30;
  for (const auto& [kv, f, lag, w] :
       {std::array{60.0, 1.0, 0.006, 5.85}, std::array{60.0, 0.0, 0.006, 5.85},
        std::array{20.0, 0.5, 0.02, 40.0}, std::array{60.0, 1.0, 0.006, 13.4}}) {
    const AxisDrive axis = drive(kv, f, lag);
    const DriveLaw law(axis, 'X');
    const std::complex<double> iw(0, w);
    const std::complex<double> gain = (kv + f * iw) / (lag * iw * iw + iw + kv);
    MotorMotion at;
    double t = 0;
    const double step = 0.05 / w;
    for (int i = 0; i < 4000; ++i, t += step) {  // Taylor polynomials: off by 30 * 0.05^6/720
      const double c = amplitude * std::cos(w * t);
      const double s = amplitude * std::sin(w * t);
      const SetCourse set =
          course({c, -w * s, -w * w * c, w * w * w * s, std::pow(w, 4) * c, -std::pow(w, 5) * s}, step);
      at = DriveCourse(law, set, at).at_end();
    }
    const double expected = amplitude * std::abs(gain) * std::cos(w * t + std::arg(gain));
    EXPECT_NEAR(amplitude * std::cos(w * t) + at.offset, expected, 1e-6) << w;
  }
}

TEST(DriveLaw, AgreesWithTheEquationInSmallStepsAndFromAnyStart) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 40; ++i) {
    const double kv = std::pow(10, 1.5 + unit(random));
    const AxisDrive axis = drive(kv, (unit(random) + 1) / 2, std::pow(10, -2 + unit(random)));
    const DriveLaw law(axis, 'X');
    const double duration = std::pow(10, -1.5 + 1.2 * unit(random));
    const double rate = 1 / duration;
    const SetCourse set =
        course({7, 100 * unit(random), 100 * unit(random) * rate, 100 * unit(random) * rate * rate,
                50 * unit(random) * std::pow(rate, 3), 50 * unit(random) * std::pow(rate, 4)},
               duration);
    const MotorMotion start{unit(random), 100 * unit(random)};
    const DriveCourse answer(law, set, start);
    const double until = duration * (unit(random) + 1.2) / 2.2;
    const MotorMotion expected = integrated(axis, set, start, until);
    EXPECT_NEAR(answer.at(until).offset, expected.offset, 1e-8) << i;
    EXPECT_NEAR(answer.at(until).velocity, expected.velocity, 1e-5) << i;
  }
}

TEST(DriveLaw, VelocityIsTheDerivativeOfTheOffset) {
  std::mt19937 random(18);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double lag : {0.0, 1e-4, 0.004, 1 / (4 * 60.0), 0.02}) {
    for (const double duration : {0.0005, 0.01, 0.3}) {
      const DriveLaw law(drive(60, 0.5, lag), 'X');
      const SetCourse set = course({0, 100 * unit(random), 500 * unit(random), 1000}, duration);
      const DriveCourse answer(law, set, {unit(random), 100 * unit(random)});
      const double h = duration * 1e-4;
      const double t = duration * 0.37;
      const double slope = (answer.at(t + h).offset - answer.at(t - h).offset) / (2 * h);
      EXPECT_NEAR(answer.at(t).velocity, slope, 1e-4 * (1 + std::abs(slope))) << lag << ' ' << duration;
    }
  }
}

// Two courses, one after the other, are the same as one.
TEST(DriveLaw, CutCoursesAreAnsweredLikeWholeOnes) {
  for (const double lag : {0.0, 1e-5, 0.001, 0.006, 0.05}) {
    const DriveLaw law(drive(60, 0.3, lag), 'X');
    const SetCourse whole = course({2, 50, -300, 2000}, 0.1);
    const MotorMotion at_once = DriveCourse(law, whole, {0.1, 20}).at_end();
    MotorMotion at{0.1, 20};
    constexpr int cuts = 50;
    for (int i = 0; i < cuts; ++i) {
      const double t = 0.1 * i / cuts;
      const SetCourse part =
          course({2 + whole.travel(t), whole.velocity(t), -300 + 2000 * t, 2000}, 0.1 / cuts);
      at = DriveCourse(law, part, at).at_end();
    }
    EXPECT_NEAR(at.offset, at_once.offset, 1e-12) << lag;
    EXPECT_NEAR(at.velocity, lag > 0 ? at_once.velocity : at.velocity, 1e-9) << lag;
  }
}

// One step of many time constants, or of few, is as many short ones that are power series: whatever the
// degree, and with poles that are complex, equal, near each other or far apart.
TEST(DriveLaw, LongStepsAreManyShortOnes) {
  std::mt19937 random(19);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double lag : {0.0, 1e-6, 1e-4, 0.001, 0.0035, 0.00415, 1 / 240.0, 0.0042, 0.006, 0.05}) {
    const DriveLaw law(drive(60, 0.3, lag), 'X');
    for (const double duration : {1e-5, 0.002, 0.0101, 0.03, 0.2}) {
      SetCourse set;
      set.duration = duration;
      double factorial = 1;
      for (std::size_t k = 1; k <= SetCourse::order; ++k) {
        factorial *= static_cast<double>(k);
        set.derivative[k] = unit(random) * factorial / std::pow(duration, static_cast<double>(k));
      }
      const MotorMotion start{0.1, 5};
      const MotorMotion at_once = DriveCourse(law, set, start).at_end();
      MotorMotion at = start;
      const int cuts = static_cast<int>(std::ceil(duration * law.fastest_rate()));
      for (int i = 0; i < std::min(cuts, 300); ++i) {
        SetCourse part;
        part.duration = duration / std::min(cuts, 300);
        const double t = i * part.duration;
        for (std::size_t k = 0; k <= SetCourse::order; ++k) {
          double sum = 0;
          for (std::size_t m = SetCourse::order; m > k; --m) {
            sum = t / static_cast<double>(m - k) * (set.derivative[m] + sum);
          }
          part.derivative[k] = set.derivative[k] + sum;
        }
        at = DriveCourse(law, part, at).at_end();
      }
      EXPECT_NEAR(at.offset, at_once.offset, 1e-10) << lag << ' ' << duration;
    }
  }
}

// The energy of a deviation, Tv y'^2/2 + Kv y^2/2, is lost at the rate y'^2 and never grows at rest.
TEST(DriveLaw, DeviationAtRestLosesTheEnergyThatItsVelocityTakes) {
  for (const double lag : {0.001, 0.006, 0.05}) {
    const DriveLaw law(drive(60, 1, lag), 'X');
    const DriveCourse rest(law, course({5}, 1), {0.3, -4});
    const auto energy = [&](double t) {
      const MotorMotion at = rest.at(t);
      return lag * at.velocity * at.velocity / 2 + 60 * at.offset * at.offset / 2;
    };
    double lost = 0;
    constexpr int steps = 20000;
    const double h = 0.2 / steps;
    for (int i = 0; i < steps; ++i) {
      const double v = rest.at((i + 0.5) * h).velocity;
      lost += h * v * v;
    }
    EXPECT_NEAR(energy(0) - energy(0.2), lost, 1e-6 * energy(0)) << lag;
  }
}

TEST(DriveLaw, TendsToTheSetPathAsTheGainGrowsAndTheLagShrinks) {
  double before = 1e9;
  for (const double scale : {1.0, 4.0, 16.0, 64.0, 256.0}) {
    const double error =
        std::abs(settled_error(drive(30 * scale, 0.2, 0.006 / scale), course({0, 100, 300}, 1)));
    EXPECT_LT(error, 0.3 * before) << scale;
    before = error;
  }
  EXPECT_EQ(settled_error(AxisDrive(), course({0, 100, 300}, 1)), 0);
}

TEST(DriveLaw, CriticalDampingIsTheLimitOfBothSides) {
  const SetCourse set = course({0, 100, -500, 800}, 0.1);
  const auto answer = [&](double lag) {
    const DriveLaw law(drive(50, 0.4, lag), 'X');
    return DriveCourse(law, set, {0.2, 3}).at_end().offset;
  };
  constexpr double critical = 1 / (4 * 50.0);
  EXPECT_NEAR(answer(critical * (1 - 1e-9)), answer(critical), 1e-8);
  EXPECT_NEAR(answer(critical * (1 + 1e-9)), answer(critical), 1e-8);
}

TEST(DriveLaw, VeryLongAndVeryShortCoursesStayFinite) {
  for (const double lag : {0.0, 1e-6, 0.006, 1.0}) {
    const DriveLaw law(drive(60, 1, lag), 'X');
    const MotorMotion after_a_day = DriveCourse(law, course({5}, 86400), {1, 100}).at_end();
    EXPECT_NEAR(after_a_day.offset, 0, 1e-12) << lag;
    const MotorMotion at_once = DriveCourse(law, course({5, 100}, 1e-12), {1, 100}).at_end();
    EXPECT_NEAR(at_once.offset, 1, 1e-6) << lag;
    const MotorMotion nothing = DriveCourse(law, course({5, 100}, 0), {1, 100}).at_end();
    EXPECT_NEAR(nothing.offset, 1, 1e-12) << lag;
  }
}

TEST(DriveLaw, OvershootIsThatOfADampedLoop) {
  EXPECT_EQ(drive_overshoot(drive(60, 0, 0)), 0);
  EXPECT_EQ(drive_overshoot(drive(50, 0, 1 / 200.0)), 0);
  // Damping 0.5: 16.3 %.
  EXPECT_NEAR(drive_overshoot(drive(50, 0, 1 / 50.0)), 0.1630, 5e-5);
  // The largest value of the step answer.
  const AxisDrive axis = drive(40, 0, 0.03);
  const DriveLaw law(axis, 'X');
  const DriveCourse step(law, course({0}, 1), {-1, 0});
  double highest = 0;
  for (int i = 0; i < 10000; ++i) {
    highest = std::max(highest, step.at(i * 1e-4).offset);
  }
  EXPECT_NEAR(drive_overshoot(axis), highest, 1e-6);
}

TEST(DriveLaw, ValuesWithoutAGainAreRefused) {
  AxisDrive axis;
  axis.lag = 0.006;
  EXPECT_THAT([&] { DriveLaw(axis, 'Y'); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("give Y.kv in 1/s")));
  axis.gain = 60;
  axis.friction_spike = 0.01;
  EXPECT_THAT([&] { DriveLaw(axis, 'Y'); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("give Y.friction_time in ms")));
}

}  // namespace
}  // namespace feedscope
