#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/contract/checks.h"
#include "tests/contract/random_case.h"

namespace feedscope::contract {

/// Reads the program, runs it and checks all that must hold: every promise that is broken, once each, so that
/// one that is known to be broken hides no other.
std::vector<Finding> check_case(const Case& example);
/// Of `findings` the one of `check`, if any.
Result finding_of(const std::vector<Finding>& findings, const std::string& check);

/// The program with every block left out without which the same promise is still broken.
Case smallest(const Case& broken, const std::string& check);

/// Writes program and machine file of a broken case into `folder`; says what is broken and how to see it.
std::string report(const Case& broken, const Finding& finding, const std::filesystem::path& folder,
                   const std::string& name);

}  // namespace feedscope::contract
