#include "core/program/iso/iso_reader.h"
#include "core/program/program.h"

namespace feedscope {

Program read_program(std::shared_ptr<const SourceText> source, Progress* progress,
                     const ReadOptions& options) {
  const Dialect dialect = options.dialect.value_or(recognise(*source));
  Program program = IsoReader(std::move(source), options, progress).read();
  program.dialect = dialect;
  return program;
}

}  // namespace feedscope
