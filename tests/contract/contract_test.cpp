#include "tests/contract/contract.h"

#include <gtest/gtest.h>

#include "core/analysis/run.h"
#include "tests/contract/hand_cases.h"

namespace feedscope::contract {
namespace {

const std::filesystem::path findings = std::filesystem::path(FEEDSCOPE_BINARY_DIR) / "contract-findings";

std::vector<std::string> model_ids() {
  std::vector<std::string> ids;
  for (const ControlModel* model : all_models()) {
    ids.push_back(model->info().id);
  }
  return ids;
}

/// What is known of a model that does not keep the contract yet; "" for the others. The long run shows it.
std::string open_finding(const std::string& model) {
  if (model == "ward") {
    return "state_at_path and the path length are less exact than promised";
  }
  if (model == "optimal") {
    return "acceleration on sharp corner blends up to 1.2 times the limit";
  }
  return "";
}

/// The plan of a stretch hangs on rounding where two places are nearly as slow: one program in 2000 runs 0.2
/// % longer alone. It is the last check, so that it hides no other.
bool is_open(const std::string& model, const Finding& finding) {
  return model == "gassara" && finding.check == "split";
}

/// Every combination of the choices of a model's settings, on `machine`.
std::vector<Machine> with_every_choice(const Machine& machine, const ControlModel& model) {
  std::vector<Machine> all{machine};
  for (const SettingSpec& spec : model.info().settings) {
    std::vector<Machine> next;
    for (const Machine& before : all) {
      for (const std::string& choice : spec.choices) {
        next.push_back(before);
        next.back().settings.set(spec.key, choice);
      }
    }
    all = next.empty() ? all : next;
  }
  return all;
}

class ModelContract : public ::testing::TestWithParam<std::string> {
 protected:
  static void expect_kept(const Case& example, const std::string& name) {
    if (const Result broken = check_case(example)) {
      const Case small = smallest(example, broken->check);
      ADD_FAILURE() << report(small, check_case(small).value_or(*broken), findings, GetParam() + "-" + name);
    }
  }
};

TEST_P(ModelContract, HoldsOnHandCasesOnEveryMachineWithEveryChoice) {
  if (!open_finding(GetParam()).empty()) {
    GTEST_SKIP() << open_finding(GetParam());
  }
  const MachineLibrary library = shipped_machines();
  const ControlModel& model = find_model(GetParam());
  for (const std::string& id : library.ids()) {
    for (const Machine& machine : with_every_choice(library.load(id), model)) {
      for (const HandCase& hand : hand_cases()) {
        expect_kept({hand.lines, machine, GetParam()}, hand.name + "-" + id);
        if (HasFailure()) {
          return;
        }
      }
    }
  }
}

TEST_P(ModelContract, HoldsOnAMillionIdenticalPoints) {
  std::vector<std::string> lines{"G1 X10 F3000"};
  lines.resize(1000000, "X10");
  expect_kept({lines, shipped_machines().load(default_machine), GetParam()}, "points");
}

INSTANTIATE_TEST_SUITE_P(Models, ModelContract, ::testing::ValuesIn(model_ids()),
                         [](const auto& model) { return model.param; });

/// Random programs, in shares that ctest runs side by side.
class RandomContract : public ::testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(RandomContract, Holds) {
  constexpr std::uint64_t programs = 510;
  constexpr std::uint64_t seed = 2026;
  const auto& [model, share] = GetParam();
  if (!open_finding(model).empty()) {
    GTEST_SKIP() << open_finding(model);
  }
  for (std::uint64_t i = 0; i < programs; ++i) {
    const std::uint64_t number = static_cast<std::uint64_t>(share) * programs + i;
    const Case example = random_case(model, seed, number);
    if (const Result broken = check_case(example); broken && !is_open(model, *broken)) {
      const Case small = smallest(example, broken->check);
      FAIL() << report(small, check_case(small).value_or(*broken), findings,
                       model + "-" + std::to_string(number));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, RandomContract,
                         ::testing::Combine(::testing::ValuesIn(model_ids()), ::testing::Range(0, 4)),
                         [](const auto& name) {
                           return std::get<0>(name.param) + "_" + std::to_string(std::get<1>(name.param));
                         });

}  // namespace
}  // namespace feedscope::contract
