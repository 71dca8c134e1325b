// Something wrong or odd, as a value: a code with its arguments. A code is an English text and its room;
// sentences::wordsOf turns faults into sentences.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

// As defined by Qt, for rooms that do not use Qt: lupdate finds these.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(scope, x) x
#endif
#ifndef QT_TRANSLATE_N_NOOP
#define QT_TRANSLATE_N_NOOP(scope, x) x
#endif

namespace mapwright {

/// A kind of fault: its room and its text. Two codes of a room never have the same text.
struct FaultCode {
  /// How the causes are appended if the text has no placeholder for them (after those of the arguments).
  enum class Causes {
    AfterColon,  // "It cannot be loaded: no answer", without a full stop
    Continued,   // the same, and more may follow: "slice 0: no data; slice 1: …"
    Capital,     // "Version 3: The robot does not answer."
    Sentence,    // a sentence of their own, after it
    Alone,       // nothing but the causes
  };

  const char* room = "";  // also the translation context
  const char* text = "";  // English; %1 is the first argument
  Causes causes = Causes::AfterColon;

  constexpr bool any() const { return *text != '\0'; }
  friend constexpr bool operator==(const FaultCode& a, const FaultCode& b) {
    return std::string_view(a.text) == b.text && std::string_view(a.room) == b.room;
  }
};

/// The code of a fault that is found in one place only, with its words there. What is compared, grouped or
/// documented has a code with a name in the room's faults.h. lupdate reads this as QT_TRANSLATE_NOOP.
constexpr FaultCode faultText(const char* room, const char* text) { return {room, text}; }

/// What happens because of it.
enum class Consequence {
  None,
  ShownWithoutIt,
  ShownWithoutItUntilTheNext,  // and requested again for the next version
  StaysWhereItWas,
  AskedAgain,
  AskedAgainAtTheNext,  // version
  PictureBeforeStays,
  AlertsBeforeStay,
  TheyWereLeftOut,
  ItsPointsWereLeftOut,
  AskedAgainEachTime,
  ReadAnewEachTime,
  LeftAsItIs,
  NothingWritten,
};
inline constexpr Consequence kLastConsequence = Consequence::NothingWritten;

struct HttpStatus {
  int code = 0;
  bool operator==(const HttpStatus&) const = default;
};

/// Texts are untrusted plain text. Numbers with digit grouping ("51,200") are passed as texts.
using FaultArgument = std::variant<std::int64_t, double, std::string, HttpStatus>;

struct Fault {
  FaultCode code;
  std::vector<FaultArgument> arguments;
  std::vector<Fault> because;  // what lies behind it
  Consequence then = Consequence::None;

  Fault() = default;
  Fault(const FaultCode& its_code, std::vector<FaultArgument> its_arguments = {},
        std::vector<Fault> behind_it = {}, Consequence follows = Consequence::None)
      : code(its_code), arguments(std::move(its_arguments)), because(std::move(behind_it)), then(follows) {}
  bool any() const { return code.any(); }
  Fault followedBy(Consequence follows) && {
    then = follows;
    return std::move(*this);
  }
  bool operator==(const Fault&) const = default;
};

/// The same for faults that differ only in numbers: they share a row in the list of problems.
std::string patternOf(const Fault& fault);
/// A text with every number replaced: the same for "Row 12 is 3.5 m off" and "Row 7 is 1,200 m off".
std::string withoutNumbers(const std::string& text);
/// For logs: one line of untranslated words, with what lies behind it.
std::string inEnglish(const Fault& fault);

}  // namespace mapwright

/// Faults that any room can have.
namespace mapwright::fault {

/// The words of somebody else: of a robot, the system, a library.
inline constexpr FaultCode Said{"fault", "%1"};
/// the most bytes
inline constexpr FaultCode AnswerTooLong{
    "fault", QT_TRANSLATE_NOOP("fault", "the answer is longer than the %1 bytes allowed")};

inline Fault said(std::string words) { return {Said, {std::move(words)}}; }

}  // namespace mapwright::fault
