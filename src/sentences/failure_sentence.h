// Texts for failed requests.
#pragma once

#include <string>

#include "map/failure.h"

namespace mapwright::sentences {

/// "It cannot be loaded: the robot answered 404 (not found): No such map." Plain text, without its subject,
/// which the caller shows next to it.
std::string sentenceOf(const map::Failure& failure);

/// "The robot answered 404 (not found): No such map.": only the reason, if the caller describes what happened
/// itself.
std::string failureReason(const map::Failure& failure);

}  // namespace mapwright::sentences
