#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/samples/samples.h"

/// Writes every sample program into a folder: generate_samples FOLDER
int main(int argc, char** argv) {
  if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
    std::fputs("usage: generate_samples FOLDER (an existing folder, as resources/programs)\n", stderr);
    return 2;
  }
  for (const auto& sample : feedscope::samples::all_samples()) {
    const std::filesystem::path file = std::filesystem::path(argv[1]) / sample.file_name;
    std::ofstream out(file, std::ios::binary);
    if (!(out << sample.text).flush()) {
      std::fprintf(stderr, "generate_samples: cannot write %s\n", file.c_str());
      return 2;
    }
  }
  return 0;
}
