#pragma once

#include <QString>
#include <exception>
#include <string>

namespace feedscope::ui {

/// What an error says, in the user's language; the place in front, as "part.toml:3:1: ", stays. Where no
/// pattern has it (composed_text), it stays as it is, as does what libraries say.
QString failure_text(const std::string& what);
QString failure_text(const std::exception& error);

}  // namespace feedscope::ui
