// Sentences put together from words of others, who may or may not have ended theirs.
#pragma once

#include <string>

namespace mapwright::words {

/// Words as a sentence that another one can follow: they begin large and end with one full stop, unless with
/// another end (! ? …). Empty stays empty.
std::string asSentence(std::string words);
/// Words to be followed by more in the same sentence: without full stop and blanks at their end.
std::string withoutStop(std::string words);
/// "It cannot be had: no answer." out of "It cannot be had" and "no answer" or "no answer."; without a reason
/// the sentence ends before the colon.
std::string because(std::string what, std::string reason);

}  // namespace mapwright::words
