#pragma once

#include <string>
#include <vector>

#include "core/analysis/study/study.h"

namespace feedscope {

/// Figures of a study for people: a table for every curve, in which the fastest run within the bound is
/// marked by a star; then in sentences the fastest setting and what limits at both ends; operations, if they
/// were asked for, of the fastest run (of the one with the least error where none keeps the bound).
/// `assignments`: what --set changed, told in the heading.
std::string study_text(const LoadedProgram& program, const Study& study,
                       const std::vector<std::string>& assignments);

/// Which of the runs is the fastest within the bound that the study has.
std::string fastest_text(const Study& study);

/// Names that tell the runs apart: machine, model, swept values or tolerance, as far as they differ; else
/// by their number where that tells them not apart.
std::vector<std::string> names_among(const Study& study);

/// The operations of one run as a table.
std::string operations_text(const Study& study, const StudyRun& run);

}  // namespace feedscope
