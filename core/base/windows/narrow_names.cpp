#include <cwchar>

// std::filesystem::path makes its wide characters of a narrow name by std::codecvt, which in libstdc++ for
// MinGW asks mbrtowc(), and that knows no UTF-8 in the runtime library of MinGW. The linker gives its calls
// to this function (option --wrap in core/base/CMakeLists.txt), so that every narrow name is UTF-8, whoever
// makes a path of it.

namespace {

constexpr char32_t replacement = 0xFFFD;

struct Character {
  char32_t code = replacement;
  int bytes = 1;
};

/// The first character of UTF-8 text; the replacement character, one byte long, where the text is invalid.
Character first_of(const char* text, std::size_t size) {
  const auto first = static_cast<unsigned char>(*text);
  const int length = first < 0x80   ? 1
                     : first < 0xC2 ? 0
                     : first < 0xE0 ? 2
                     : first < 0xF0 ? 3
                     : first < 0xF5 ? 4
                                    : 0;
  if (length == 0 || size < static_cast<std::size_t>(length)) {
    return {};
  }
  char32_t code = first & (length == 1 ? 0x7FU : 0xFFU >> (length + 1));
  for (int i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0U) != 0x80) {
      return {};
    }
    code = code << 6 | (byte & 0x3FU);
  }
  return {code, length};
}

}  // namespace

/// As mbrtowc() for UTF-8, but invalid bytes are no error: a program in Latin-1 may name a file, which does
/// not exist then. A character outside the basic plane becomes two wide ones: the first call takes three of
/// its bytes and keeps the low surrogate in `state`, the second takes the last byte.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* out, const char* bytes, std::size_t size,
                                      std::mbstate_t* state) {
  static thread_local std::mbstate_t own{};
  std::mbstate_t& rest = state != nullptr ? *state : own;
  if (bytes == nullptr) {
    rest = {};
    return 0;
  }
  if (size == 0) {
    return static_cast<std::size_t>(-2);  // incomplete
  }
  wchar_t wide = 0;
  std::size_t taken = 1;
  if (rest != 0) {
    wide = static_cast<wchar_t>(rest);
    rest = {};
  } else {
    const Character character = first_of(bytes, size);
    constexpr char32_t of_two = 0x10000;  // the first that needs two wide ones
    const bool two = character.code >= of_two;
    wide = static_cast<wchar_t>(two ? 0xD800 + ((character.code - of_two) >> 10) : character.code);
    rest = static_cast<std::mbstate_t>(two ? 0xDC00 + ((character.code - of_two) & 0x3FF) : 0);
    taken = static_cast<std::size_t>(two ? character.bytes - 1 : character.bytes);
  }
  if (out != nullptr) {
    *out = wide;
  }
  return wide == 0 ? 0 : taken;
}
