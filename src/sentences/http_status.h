// Names of HTTP statuses.
#pragma once

#include <QString>

namespace mapwright::sentences {

/// "404 (not found)"; "299" if the number has no common name.
QString statusWords(int status);

}  // namespace mapwright::sentences
