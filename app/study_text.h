#pragma once

#include <string>
#include <vector>

#include "core/analysis/study/study.h"

namespace feedscope {

/// Figures of a study for people: a table for every curve, with a star at the recommended run of the curve;
/// then sentences on it and on the limits at both ends; on request its operations (those of the run with the
/// least error if none keeps the bound). `assignments`: those of --set, named in the heading.
std::string study_text(const LoadedProgram& program, const Study& study,
                       const std::vector<std::string>& assignments);

/// The fastest run within the study's bound.
std::string fastest_text(const Study& study);

/// Names that distinguish the runs: machine, model, swept values or tolerance, as far as they differ; else
/// numbers, where names are still equal.
std::vector<std::string> names_among(const Study& study);

/// The operations of one run as a table.
std::string operations_text(const Study& study, const StudyRun& run);

}  // namespace feedscope
