#include "core/load/material.h"

#include <algorithm>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/load/load_file.h"

namespace feedscope {

ForceLaw force_law(const Material& material) {
  if (material.law == CuttingLaw::linear_edge) {
    return {material.cutting, material.edge, 1};
  }
  ForceLaw law;
  law.exponent = 1 - material.exponent;
  for (std::size_t i = 0; i < law.chip.size(); ++i) {
    law.chip[i] = material.specific_force * material.share[i];
  }
  return law;
}

std::vector<Material> shipped_materials() {
  return read_materials(data_folder() / "resources" / "materials.toml");
}

Material find_material(const std::string& id, const std::vector<Material>& own) {
  std::vector<std::string> known;
  for (const std::vector<Material>& all : {own, shipped_materials()}) {
    for (const Material& material : all) {
      if (material.id == id) {
        return material;
      }
      known.push_back(material.id);
    }
  }
  const std::string nearest = nearest_name(id, known);
  throw InputError(
      message(NC_("core", "material '{}' is not known; {}, or add a [[material]] with its coefficients"), id,
              nearest.empty() ? message(NC_("core", "use one such as '{}'"), known.front())
                              : message(NC_("core", "did you mean '{}'?"), nearest)));
}

}  // namespace feedscope
