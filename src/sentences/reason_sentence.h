// What people read about what was found.
#pragma once

#include <vector>

#include <QString>

#include "map/reason.h"

namespace mapwright::sentences {

/// "Version 5 is broken: 3,200 bytes where 51,200 were expected. Shown without it." Plain text, without its
/// subject. Most are whole sentences; causes of others ("its pose lies …") begin small and have no stop.
QString wordsOf(const map::Reason& reason);

/// Several in one, "; " between them.
QString wordsOf(const std::vector<map::Reason>& reasons);

/// The same as a sentence in any case: "Its pose lies …."; empty for none.
QString sentenceOf(const map::Reason& reason);

/// The words before arguments are put in, for `count` of what the code counts: "It names no image.".
QString templateOf(map::ReasonCode code, int count = 2);
/// What follows, as a sentence; empty for None.
QString consequenceOf(map::Consequence consequence);

}  // namespace mapwright::sentences
