#include "core/models/cam/cam_model.h"
#include "core/models/control_model.h"
#include "core/models/essid/essid_model.h"
#include "core/models/gassara/gassara_model.h"
#include "core/models/grbl/grbl_model.h"
#include "core/models/klipper/klipper_model.h"
#include "core/models/linuxcnc/linuxcnc_model.h"
#include "core/models/msaddek/msaddek_model.h"
#include "core/models/optimal/optimal_model.h"
#include "core/models/tapie/tapie_model.h"
#include "core/models/ward/ward_model.h"

namespace feedscope {

const std::vector<const ControlModel*>& all_models() {
  static const CamModel cam;
  static const EssidModel essid;
  static const GassaraModel gassara;
  static const TapieModel tapie;
  static const MsaddekModel msaddek;
  static const WardModel ward;
  static const OptimalModel optimal;
  static const GrblModel grbl;
  static const KlipperModel klipper;
  static const LinuxCncModel linuxcnc;
  static const std::vector<const ControlModel*> models{&cam,  &essid,   &gassara, &tapie,   &msaddek,
                                                       &ward, &optimal, &grbl,    &klipper, &linuxcnc};
  return models;
}

}  // namespace feedscope
