#pragma once

namespace feedscope::ui {

/// Adds the faces of DejaVu Sans and DejaVu Sans Mono that the system lacks, from the program's resources, so
/// that text appears on a system without fonts. If a system has no font at all, they become the
/// application's. Needs a QGuiApplication; the second call does nothing.
void add_missing_fonts();

}  // namespace feedscope::ui
