#pragma once

#include "tests/ui/run_fixture.h"
#include "ui/report/report_input.h"

namespace feedscope::test {

/// One program on one machine with two tolerances.
inline ui::ReportInput two_runs(const std::string& name = "test.nc") {
  const auto source = std::make_shared<const SourceText>(name, small_program);
  const LoadedProgram program = load_program(source);
  std::vector<std::shared_ptr<const ui::ShownRun>> shown;
  for (const double tolerance : {0.01, 0.05}) {
    shown.push_back(ui::make_shown(simulate_run(program, make_setup({"", "essid", tolerance, {}}))));
  }
  ui::ReportInput input;
  input.runs = ui::report_runs(shown);
  input.commands = {"feedscope report test.nc"};
  return input;
}

/// The same with every appendix.
inline ui::ReportInput with_appendices(ui::ReportInput input) {
  input.with = {QStringLiteral("all")};
  return input;
}

/// A callout half way along the first corner's second line.
inline ui::Annotation note(const QString& text) {
  ui::Annotation annotation;
  annotation.place = {1, 0.5};
  annotation.text = text;
  return annotation;
}

}  // namespace feedscope::test
