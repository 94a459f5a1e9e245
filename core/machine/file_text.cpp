#include "core/machine/file_text.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace feedscope {

std::string file_text(const std::filesystem::path& file, Translatable what, std::size_t largest) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(message(NC_("core", "'{}' is a folder; give a {}"), file.string(), what));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError(message(NC_("core", "cannot read {} '{}': {}"), what, file.string(),
                             reason_of(std::error_code(errno, std::generic_category()))));
  }
  const std::size_t most = largest << 20;
  std::string text(most + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  const auto size = static_cast<std::size_t>(in.gcount());
  if (size > most) {
    throw InputError(
        message(NC_("core", "'{}' is larger than {} MiB and cannot be a {}"), file.string(), largest, what));
  }
  text.resize(size);
  return text;
}

}  // namespace feedscope
