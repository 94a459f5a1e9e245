#pragma once

#include <malloc.h>

#include <cstddef>
#include <fstream>

namespace feedscope::test {

/// Bytes that malloc has given out and not got back, in all its arenas.
inline std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Bytes of memory that the process holds.
inline std::size_t resident_bytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  constexpr std::size_t page = 4096;
  return resident * page;
}

inline constexpr std::size_t megabyte = 1'000'000;

}  // namespace feedscope::test
