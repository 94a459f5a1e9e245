#pragma once

#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FEEDSCOPE_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FEEDSCOPE_SANITIZED
#endif

namespace feedscope::test {

/// Whether a sanitizer runs along: memory and times are then no measure of the program.
#ifdef FEEDSCOPE_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace feedscope::test
