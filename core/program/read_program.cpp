#include "core/program/heidenhain/heidenhain_reader.h"
#include "core/program/iso/iso_reader.h"
#include "core/program/program.h"

namespace feedscope {

Program read_program(std::shared_ptr<const SourceText> source, Progress* progress,
                     const ReadOptions& options) {
  ReadOptions resolved = options;
  resolved.dialect = options.dialect.value_or(recognise(*source));
  Program program = *resolved.dialect == Dialect::heidenhain
                        ? HeidenhainReader(std::move(source), resolved, progress).read()
                        : IsoReader(std::move(source), resolved, progress).read();
  program.dialect = *resolved.dialect;
  return program;
}

}  // namespace feedscope
