#include "core/program/heidenhain/heidenhain_iso_reader.h"
#include "core/program/heidenhain/heidenhain_reader.h"
#include "core/program/iso/iso_reader.h"
#include "core/program/program.h"
#include "core/program/sinumerik/sinumerik_reader.h"

namespace feedscope {

namespace {

Program read_as(Dialect dialect, std::shared_ptr<const SourceText> source, const ReadOptions& options,
                Progress* progress) {
  switch (dialect) {
    case Dialect::sinumerik:
      return SinumerikReader(std::move(source), options, progress).read();
    case Dialect::heidenhain:
      return HeidenhainReader(std::move(source), options, progress).read();
    case Dialect::heidenhain_iso:
      return HeidenhainIsoReader(std::move(source), options, progress).read();
    default:
      return IsoReader(std::move(source), options, progress).read();
  }
}

}  // namespace

Program read_program(std::shared_ptr<const SourceText> source, Progress* progress,
                     const ReadOptions& options) {
  ReadOptions resolved = options;
  resolved.dialect = options.dialect.value_or(recognise(*source));
  Program program = read_as(*resolved.dialect, std::move(source), resolved, progress);
  program.dialect = *resolved.dialect;
  return program;
}

}  // namespace feedscope
