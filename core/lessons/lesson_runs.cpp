#include "core/lessons/lesson_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"

namespace feedscope {
namespace {

double related(Relation relation, double value, double other) {
  switch (relation) {
    case Relation::ratio:
      return value / other;
    case Relation::difference:
      return value - other;
    case Relation::percent_more:
      return 100 * (value / other - 1);
    case Relation::percent_less:
      return 100 * (1 - value / other);
  }
  return value;
}

}  // namespace

const LoadedProgram& LessonRuns::program(const std::filesystem::path& file, const Machine& machine,
                                         Progress* progress) {
  const std::pair key(file, machine.id);
  const auto known = programs_.find(key);
  if (known != programs_.end()) {
    return known->second;
  }
  LoadedProgram loaded = load_program(file, progress, reading_on({}, machine));
  const auto& diagnostics = loaded.program->diagnostics;
  const auto error = std::find_if(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::error;
  });
  if (error != diagnostics.end()) {
    throw InputError(message(NC_("core", "program '{}' of the lesson has an error on line {}: {}"),
                             file.string(), error->line, error->message));
  }
  return programs_.emplace(key, std::move(loaded)).first->second;
}

const Run& LessonRuns::run(const Changes& changes, Progress* progress) {
  const auto known = runs_.find(changes);
  if (known != runs_.end()) {
    return known->second;
  }
  LessonSetup setup = setups_.set_up(lesson_, changes);
  const LoadedProgram& input = program(setup.program, setup.setup.machine, progress);
  return runs_.emplace(changes, simulate_run(input, std::move(setup.setup), progress)).first->second;
}

double LessonRuns::value(const LessonQuantity& quantity, Progress* progress) {
  const double value = measured(quantity.measure, run(quantity.with, progress));
  if (!quantity.against) {
    return value;
  }
  const double other = measured(quantity.measure, run(*quantity.against, progress));
  if (other == 0 && quantity.relation != Relation::difference) {
    throw InputError(
        message(NC_("core", "{}: the second is 0, so there is no ratio"), quantity_text(quantity)));
  }
  return related(quantity.relation, value, other);
}

ClaimResult LessonRuns::check(const Claim& claim, Progress* progress) {
  ClaimResult result;
  result.value = value(claim.quantity, progress);
  if (const auto* changes = std::get_if<Changes>(&claim.bound)) {
    LessonQuantity other = claim.quantity;
    other.with = *changes;
    result.bound = value(other, progress);
  } else {
    result.bound = std::get<double>(claim.bound);
  }
  switch (claim.kind) {
    case Claim::Kind::less_than:
      result.holds = result.value < result.bound;
      break;
    case Claim::Kind::more_than:
      result.holds = result.value > result.bound;
      break;
    case Claim::Kind::about: {
      const double allowed =
          claim.within_percent ? std::abs(result.bound) * claim.within / 100 : claim.within;
      result.holds = std::abs(result.value - result.bound) <= allowed;
      break;
    }
    case Claim::Kind::between:
      result.holds = result.value >= result.bound && result.value <= claim.upper;
      break;
  }
  return result;
}

WrittenNumbers LessonRuns::numbers(Progress* progress) {
  WrittenNumbers numbers;
  for (const auto& [name, given] : lesson_.given) {
    numbers[name] = given.written;
  }
  for (const auto& [name, quantity] : lesson_.numbers) {
    numbers[name] = value_text(quantity, value(quantity, progress), lesson_.language);
  }
  return numbers;
}

}  // namespace feedscope
