#include "core/base/happens_before.h"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace feedscope {

void HappensBefore::before() {
#ifdef __SANITIZE_THREAD__
  __tsan_release(&place_);
#endif
}

void HappensBefore::after() {
#ifdef __SANITIZE_THREAD__
  __tsan_acquire(&place_);
#endif
}

}  // namespace feedscope
