// What people read about a request that failed.
#pragma once

#include <string>

#include "map/failure.h"

namespace mapwright::sentences {

/// "It cannot be had: the robot answered 404 (not found): No such map." Plain text, without its subject,
/// which whoever shows it names beside.
std::string sentenceOf(const map::Failure& failure);

/// "The robot answered 404 (not found): No such map.": the reason alone, for whoever says by himself what has
/// come about and what has not.
std::string whyOf(const map::Failure& failure);

}  // namespace mapwright::sentences
