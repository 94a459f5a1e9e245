#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace feedscope {

/// Dependence of the force on a tooth on the chip thickness h, with width of cut b.
enum class CuttingLaw : std::uint8_t {
  linear_edge,  ///< F = (K_c h + K_e) b: cutting and edge coefficients
  kienzle,      ///< F_t = k_c1.1 h^(1 - m_c) b; F_r and F_a are shares of it
};

/// Cutting data of a material, measured for one geometry of cutting edge.
struct Material {
  std::string id;      ///< as in load files: "aluminium-7075-t6"
  std::string title;   ///< for display
  std::string source;  ///< of the numbers
  CuttingLaw law = CuttingLaw::linear_edge;
  // Tangential, radial, axial:
  std::array<double, 3> cutting{};       ///< K_tc, K_rc, K_ac of the linear law [N/mm2]
  std::array<double, 3> edge{};          ///< K_te, K_re, K_ae of the linear law [N/mm]
  double specific_force = 0;             ///< k_c1.1 of Kienzle's law, at h = b = 1 mm [N/mm2]
  double exponent = 0;                   ///< m_c of Kienzle's law
  std::array<double, 3> share{1, 0, 0};  ///< F/F_t of Kienzle's law; the first is 1

  bool operator==(const Material&) const = default;
};

/// Common form of both laws: F/b = chip (h/mm)^exponent + edge, tangential, radial and axial [N/mm].
struct ForceLaw {
  std::array<double, 3> chip{};
  std::array<double, 3> edge{};
  double exponent = 1;
};
ForceLaw force_law(const Material& material);

/// Materials of resources/materials.toml in data_folder(), with typical values. Throws InputError if the file
/// is unreadable or invalid.
std::vector<Material> shipped_materials();

/// Material with this `id`, own ones before shipped ones. Throws InputError with the nearest id if there is
/// none.
Material find_material(const std::string& id, const std::vector<Material>& own);

}  // namespace feedscope
