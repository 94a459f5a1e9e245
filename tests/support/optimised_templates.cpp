// Templates of the standard library as the program has them. Where tests are compiled without optimising
// (FEEDSCOPE_TEST_OPTIONS), they bring along templates that are slow, and the linker takes the first of each
// that it sees, for the libraries under test too: these come first.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"

template class std::basic_string<char>;
template class std::basic_string_view<char>;
template class std::vector<double>;
template class std::vector<std::string>;
template class std::vector<feedscope::Vec3>;
