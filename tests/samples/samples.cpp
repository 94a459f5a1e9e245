#include "tests/samples/samples.h"

namespace feedscope::samples {

std::vector<Sample> all_samples() {
  return {essid_table1(),   essid_spline(),    tapie_bore(),
          msaddek_pocket(), trochoidal_slot(), freeform_finish()};
}

}  // namespace feedscope::samples
