#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace feedscope {

/// How the force on a tooth depends on the chip thickness h, by width of cut b.
enum class CuttingLaw : std::uint8_t {
  linear_edge,  ///< F = (K_c h + K_e) b: cutting and edge coefficients
  kienzle,      ///< F_t = k_c1.1 h^(1 - m_c) b, F_r and F_a a share of it
};

/// What it takes to cut a material, as it is measured for one geometry of cutting edge.
struct Material {
  std::string id;      ///< as load files name it: "aluminium-7075-t6"
  std::string title;   ///< for people
  std::string source;  ///< where the numbers come from
  CuttingLaw law = CuttingLaw::linear_edge;
  // Tangential, radial, axial:
  std::array<double, 3> cutting{};       ///< K_tc, K_rc, K_ac of the linear law [N/mm2]
  std::array<double, 3> edge{};          ///< K_te, K_re, K_ae of the linear law [N/mm]
  double specific_force = 0;             ///< k_c1.1 of Kienzle's, at h = b = 1 mm [N/mm2]
  double exponent = 0;                   ///< m_c of Kienzle's
  std::array<double, 3> share{1, 0, 0};  ///< F/F_t of Kienzle's; the first is 1

  bool operator==(const Material&) const = default;
};

/// F/b = chip (h/mm)^exponent + edge, tangential, radial and axial: both laws [N/mm].
struct ForceLaw {
  std::array<double, 3> chip{};
  std::array<double, 3> edge{};
  double exponent = 1;
};
ForceLaw force_law(const Material& material);

/// The materials of resources/materials.toml in data_folder(), typical values each. Throws InputError if the
/// file cannot be read or is wrong.
std::vector<Material> shipped_materials();

/// The one of `id`, own ones before shipped ones. Throws InputError with the nearest id if there is none.
Material find_material(const std::string& id, const std::vector<Material>& own);

}  // namespace feedscope
