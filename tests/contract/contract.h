#pragma once

#include <filesystem>
#include <string>

#include "tests/contract/checks.h"
#include "tests/contract/random_case.h"

namespace feedscope::contract {

/// Reads the program, runs it and checks all that must hold; the first promise that is broken, if any.
Result check_case(const Case& example);

/// The program with every block left out without which the same promise is still broken.
Case smallest(const Case& broken, const std::string& check);

/// Writes program and machine file of a broken case into `folder`; says what is broken and how to see it.
std::string report(const Case& broken, const Finding& finding, const std::filesystem::path& folder,
                   const std::string& name);

}  // namespace feedscope::contract
