#pragma once

#include <string>

#include "core/analysis/run/run.h"

namespace feedscope::test {

/// Simulates a program text on a shipped machine with one of its models.
inline Run simulate_text(const std::string& text, const std::string& model = "essid",
                         const std::string& machine = "spinner-mvc850") {
  SetupRequest request;
  request.machine = machine;
  request.model = model;
  return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", text)), make_setup(request));
}

/// Three blocks round two corners and an arc; every line moves but the first and the last.
inline const std::string small_program =
    "G21 G90 G94 F3000\n"
    "G1 X20 Y0\n"
    "G1 X40 Y15\n"
    "G2 X60 Y15 I10 J0\n"
    "G1 X60 Y60\n"
    "M30\n";

}  // namespace feedscope::test
