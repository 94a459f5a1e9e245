#pragma once

#include <QString>
#include <exception>
#include <string>

namespace feedscope::ui {

/// An error message in the user's language; its place, as "part.toml:3:1: ", remains. Texts without a pattern
/// (composed_text) remain as they are, as do those of libraries.
QString failure_text(const std::string& what);
QString failure_text(const std::exception& error);

}  // namespace feedscope::ui
