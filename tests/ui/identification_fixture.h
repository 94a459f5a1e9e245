#pragma once

#include <memory>

#include "ui/identification/identification_state.h"

namespace feedscope::test {

/// A number that was found.
inline IdentifiedParameter told_number(const std::string& key, const std::string& unit, double start,
                                       double value, double uncertainty) {
  IdentifiedParameter one;
  one.parameter.key = key;
  one.parameter.unit = unit;
  one.start = start;
  one.value = value;
  one.uncertainty = uncertainty;
  one.told = true;
  return one;
}

/// One that no recording tells.
inline IdentifiedParameter untold_number(const std::string& key, const std::string& unit, double start,
                                         const std::string& part) {
  IdentifiedParameter one;
  one.parameter.key = key;
  one.parameter.unit = unit;
  one.start = start;
  one.value = start;
  one.reason = "It changes nothing that these traces show.";
  one.told_by = part;
  return one;
}

/// A trace of 4 s, which the model misses by `lag` at its end, and a table of four sections.
inline Identification found_by(const std::string& model, double lag) {
  SetupRequest request;
  request.machine = "linuxcnc-mill";
  request.model = model;
  Identification found;
  found.setup = make_setup(request);
  found.setup.machine.axes[0].acceleration = 1300;
  found.setup.machine.provenance.insert_or_assign("X.acceleration",
                                                  Provenance{"identified from scope.csv", false});
  found.parameters = {told_number("X.acceleration", "m/s2", 0.75, 1.30021, 0.0123),
                      untold_number("Z.acceleration", "m/s2", 0.75, "SINGLE MOVES OF Z")};
  found.parameters.back().at_least = 0.5;
  Agreement trace;
  trace.measured_time = 4;
  trace.simulated_time = 4 + lag;
  trace.feed_rms = 1.5;
  trace.distance = 0.02;
  trace.simulated_distance = 0.03;
  for (int i = 0; i < 4; ++i) {
    trace.cells.push_back({0, 0, 1, 1 + lag / 4});
  }
  Agreement table;
  std::vector<SectionAgreement> sections;
  for (const char* section : {"1", "2", "3", "4-7"}) {
    sections.push_back({section, 0.5, 0.5 + lag * static_cast<double>(sections.size())});
    table.measured_time += sections.back().measured_time;
    table.simulated_time += sections.back().simulated_time;
  }
  found.agreements = {trace, table};
  found.sections = {{}, sections};
  found.residual = 1.25;
  found.feed_error = 0.0123;
  found.explains = true;
  found.simulations = 321;
  found.drives.push_back({'Y', {}, 4000, 0.0412, 0.00041, true, 0});
  return found;
}

/// Two models of which the first explains a trace and a table, and one that could not be fitted.
inline std::shared_ptr<ui::IdentificationOutcome> some_outcome() {
  auto outcome = std::make_shared<ui::IdentificationOutcome>();
  outcome->date = "2026-11-27";
  outcome->program = "0123abcd";
  outcome->recordings = {{"scope.csv", false, 2000, 4, 12345.678}, {"times.csv", true, 4, 2, 2}};
  outcome->models = {found_by("linuxcnc", 0.002), found_by("cam", -0.05)};
  outcome->models[1].explains = false;
  outcome->models[1].residual = 87.5;
  outcome->models[1].parameters[0] = untold_number("X.acceleration", "m/s2", 0.75, "");
  outcome->unfitted = {
      {"grbl", Message::as_written("the trace holds too little of its program to find anything from it"),
       ""}};
  return outcome;
}

/// Everything that can be set, and a result.
inline ui::IdentificationState some_identification(const std::filesystem::path& table) {
  ui::IdentificationState state;
  state.unused_traces = {1};
  const ui::SectionTable times{QString::fromStdString(table.string()),
                               {{"1", 0.5, 0.001, 2}, {"2", 0.5, 0.001, 3}, {"4-7", 1.234, 0.001, 5}}};
  state.tables = {{std::make_shared<const ui::SectionTable>(times), false}};
  state.choice.run = 1;
  state.choice.models = std::vector<std::string>{"linuxcnc", "cam"};
  state.choice.wanted = {{"X.jerk", true}, {"Z.velocity", false}};
  state.result = {some_outcome(), 1, true};
  return state;
}

}  // namespace feedscope::test
