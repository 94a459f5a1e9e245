// Any bytes as a session file: what is read is written back the same.
#include <QJsonDocument>
#include <cstdint>

#include "core/analysis/run/run.h"
#include "tests/fuzz/must.h"
#include "ui/session/identification_json.h"
#include "ui/session/session_file.h"

using namespace feedscope;
using namespace feedscope::ui;

namespace {

const std::filesystem::path folder = "/parts/sessions";

Session read(const QByteArray& bytes) {
  static const MachineLibrary machines = shipped_machines();
  return read_session(QJsonDocument::fromJson(bytes).object(), folder, machines).session;
}

void must_be_same(const Session& a, const Session& b) {
  fuzz::must(a.program == b.program && a.program_hash == b.program_hash, "program");
  fuzz::must(a.reading == b.reading, "reading");
  fuzz::must(a.runs == b.runs && a.current_run == b.current_run && a.cursor == b.cursor, "runs");
  fuzz::must(a.scene == b.scene && a.scenes == b.scenes, "view");
  fuzz::must(a.charts == b.charts, "charts");
  fuzz::must(a.annotations == b.annotations, "annotations");
  fuzz::must(to_json(a.identification, folder, shipped_machines()) ==
                 to_json(b.identification, folder, shipped_machines()),
             "identification");
  fuzz::must(a.layout == b.layout && a.presentation == b.presentation && a.theme == b.theme &&
                 a.program_font_size == b.program_font_size,
             "window");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const QByteArray bytes(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
  Session session;
  try {
    session = read(bytes);
  } catch (const InputError&) {
    return 0;
  }
  must_be_same(read(session_bytes(session, folder)), session);
  return 0;
}
