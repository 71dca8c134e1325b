// Builds sentences from texts that may or may not end with a full stop. Chinese ones get a Chinese stop.
#pragma once

#include <string>

namespace mapwright::words {

/// Turns text into a sentence that another one can follow: capitalised, with a full stop, unless it has
/// another end (! ? …). Empty stays empty. `chinese`: that is spoken (words/qt_plain.h knows).
std::string asSentence(std::string words, bool chinese = false);
/// Prepares text to be continued: without full stop and blanks at its end.
std::string withoutStop(std::string words);
/// "It cannot be loaded: no answer." from "It cannot be loaded" and "no answer" or "no answer."; without a
/// reason the sentence ends before the colon.
std::string because(std::string what, std::string reason, bool chinese = false);

}  // namespace mapwright::words
