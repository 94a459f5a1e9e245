#pragma once

#include <cstddef>
#include <string>

namespace feedscope::benchmark {

/// NC text of `blocks` blocks of 0.2 to 0.4 mm in rows over a smooth surface, all three coordinates in each.
std::string surface_program(std::size_t blocks);
/// NC text of `blocks` blocks: waves of tangent arcs, each pair joined by a line.
std::string arc_program(std::size_t blocks);

}  // namespace feedscope::benchmark
