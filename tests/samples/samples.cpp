#include "tests/samples/samples.h"

namespace feedscope::samples {

std::vector<Sample> all_samples() {
  std::vector<Sample> samples{essid_table1(),    essid_spline(), msaddek_pocket(),
                              trochoidal_slot(), blade(),        freeform_finish()};
  for (const std::vector<Sample>& more :
       {tapie_bores(), tapie_circles(), tapie_spirals(), lesson_programs()}) {
    samples.insert(samples.end(), more.begin(), more.end());
  }
  return samples;
}

}  // namespace feedscope::samples
