// Names of HTTP statuses.
#pragma once

#include <string>

namespace mapwright::words {

/// "404 (not found)"; "299" when the number has no common name.
std::string statusWords(int status);

}  // namespace mapwright::words
