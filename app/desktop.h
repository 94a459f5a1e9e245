#pragma once

namespace feedscope {

// The desktop that a window appears on; posix/ and windows/ have a file each.

/// Throws InputError where no window can appear; `instead`: advice for there.
void check_display(const char* instead);

/// Closes a console that the system has opened for this process alone, as Windows does for a program that is
/// started by its icon.
void close_own_console();

}  // namespace feedscope
