#include "core/program/iso/geometry/kept_modes.h"

namespace feedscope::iso {

void KeptModes::run(int code, std::uint32_t column) {
  switch (code) {
    case 70:
    case 73:
      forget();
      kept_.push_back({lines().call_depth(), modal_, path().feed_mode(), path().feed(), path().path_control(),
                       code == 73});
      break;
    case 71:
      forget();
      break;
    default:
      if (const Kept* const kept = of_call()) {
        restore(*kept);
      } else {
        report(Severity::error, "modal-state", 0, column, [] {
          return Text{NC_("core", "M72 has no modal state to restore"),
                      NC_("core", "nothing changes; write M70 before it")};
        });
      }
      break;
  }
}

KeptModes::Kept* KeptModes::of_call() {
  return !kept_.empty() && kept_.back().depth == lines().call_depth() ? &kept_.back() : nullptr;
}

void KeptModes::forget() {
  if (of_call() != nullptr) {
    kept_.pop_back();
  }
}

void KeptModes::leave_call() {
  while (!kept_.empty() && kept_.back().depth > lines().call_depth()) {
    if (kept_.back().until_return) {
      restore(kept_.back());
    }
    kept_.pop_back();
  }
}

void KeptModes::restore(const Kept& kept) {
  modal_.plane = kept.modal.plane;
  modal_.inch = kept.modal.inch;
  modal_.incremental = kept.modal.incremental;
  modal_.absolute_centers = kept.modal.absolute_centers;
  modal_.to_initial_level = kept.modal.to_initial_level;
  coordinates_.restore_work_offset(kept.modal.work_offset);
  path().set_feed_mode(kept.feed_mode);
  if (kept.feed > 0) {
    path().set_feed(kept.feed);
  }
  path().set_path_control(kept.path_control);
}

}  // namespace feedscope::iso
