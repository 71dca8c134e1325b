// What people read about what was found.
#pragma once

#include <vector>

#include <QString>

#include "fault/fault.h"

namespace mapwright::sentences {

/// "Version 5 is broken: 3,200 bytes where 51,200 were expected. Shown without it." Plain text, without its
/// subject. Most are whole sentences; causes of others ("its pose lies …") begin small and have no stop.
QString wordsOf(const Fault& fault);

/// Several in one, "; " between them.
QString wordsOf(const std::vector<Fault>& faults);

/// The same as a sentence in any case: "Its pose lies …."; empty for none.
QString sentenceOf(const Fault& fault);

/// What follows, as a sentence; empty for None.
QString consequenceOf(Consequence consequence);

}  // namespace mapwright::sentences
