// Texts for faults.
#pragma once

#include <vector>

#include <QString>

#include "fault/fault.h"

namespace mapwright::sentences {

/// "Version 5 is broken: 3,200 bytes where 51,200 were expected. Shown without it." Plain text, without its
/// subject. Most are complete sentences; causes ("its pose is …") begin in lower case without a full stop.
QString wordsOf(const Fault& fault);

/// Several in one text, separated by "; ".
QString wordsOf(const std::vector<Fault>& faults);

/// Always a complete sentence: "Its pose is …."; empty for none.
QString sentenceOf(const Fault& fault);

/// The consequence as a sentence; empty for None.
QString consequenceOf(Consequence consequence);

}  // namespace mapwright::sentences
