#include "sentences/fault_sentence.h"

#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "robot/faults.h"
#include "sentences/absence_sentence.h"
#include "sentences/http_status.h"
#include "sentences/plural.h"
#include "words/decimal.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/sentences.h"

namespace mapwright::sentences {
namespace {

QString textOf(const FaultArgument& argument) {
  if (const auto* const whole = std::get_if<std::int64_t>(&argument)) return QString::number(*whole);
  if (const auto* const number = std::get_if<double>(&argument)) {
    constexpr double kLarge = 1e5, kLargest = 1e15;  // coordinates and times: every digit counts
    const double size = std::abs(*number);
    return size >= kLarge && size < kLargest ? words::decimal(*number) : QString::number(*number, 'g', 6);
  }
  if (const auto* const status = std::get_if<HttpStatus>(&argument)) return statusWords(status->code);
  return QString::fromStdString(std::get<std::string>(argument));
}

/// The number that the sentence counts, if any: plain or grouped.
int countIn(const Fault& fault) {
  constexpr int kMany = 2;
  if (fault.arguments.empty()) return kMany;
  if (const auto* const count = std::get_if<std::int64_t>(&fault.arguments[0])) return formOf(*count);
  const auto* const text = std::get_if<std::string>(&fault.arguments[0]);
  bool is_number = false;
  const qint64 count =
      text ? QString::fromStdString(*text).remove(QLatin1Char(',')).toLongLong(&is_number) : 0;
  return is_number ? formOf(count) : kMany;
}

QString placeholderAfter(const std::vector<FaultArgument>& arguments) {
  return QLatin1Char('%') + QString::number(arguments.size() + 1);
}

/// Arguments are put in at once: what they hold is no template.
QString filled(const QString& text, const std::vector<FaultArgument>& arguments) {
  QString full;
  full.reserve(text.size());
  for (qsizetype i = 0; i < text.size(); ++i) {
    const int number = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
    if (number < 1) {
      full += text[i];
      continue;
    }
    ++i;
    if (std::size_t(number) <= arguments.size()) full += textOf(arguments[std::size_t(number) - 1]);
  }
  return full;
}

QString lackWords(const Fault& fault) {
  robot::Absence absence;
  const auto number = [&](std::size_t at) {
    const auto* const given =
        at < fault.arguments.size() ? std::get_if<std::int64_t>(&fault.arguments[at]) : nullptr;
    return given ? int(*given) : 0;
  };
  absence.reason = robot::Absence::Reason(number(1));
  for (std::size_t i = 2; i < fault.arguments.size(); ++i)
    absence.arguments.push_back(textOf(fault.arguments[i]).toStdString());
  return absenceReason(robot::Capability(number(0)), absence);
}

/// What systems say ("Permission denied") is known in other languages under the name that Qt has for it.
QString saidWords(const QString& said) {
  return QCoreApplication::translate("QIODevice", said.toUtf8().constData());
}

QString withCauses(const Fault& fault, const QString& text) {
  if (fault.because.empty()) return text;
  const QString causes = wordsOf(fault.because);
  switch (fault.code.causes) {
    case FaultCode::Causes::AfterColon:
      break;
    case FaultCode::Causes::Continued:
      return words::about(text, causes);
    case FaultCode::Causes::Capital:
      return words::because(text, words::asSentence(causes));
    case FaultCode::Causes::Sentence:
      return words::paragraph({text, words::asSentence(causes)});
    case FaultCode::Causes::Alone:
      return words::asSentence(causes);
  }
  return words::because(text, causes);
}

/// With what follows from it.
QString ended(const Fault& fault, const QString& whole) {
  if (fault.then == Consequence::None || whole.isEmpty()) return whole + consequenceOf(fault.then);
  QString ended = words::asSentence(whole);
  ended[0] = whole[0];  // it may be a name
  return words::paragraph({ended, consequenceOf(fault.then)});
}

}  // namespace

QString consequenceOf(Consequence consequence) {
  struct Text {
    Consequence consequence;
    const char* text;
  };
  static constexpr Text kTexts[] = {
      {Consequence::ShownWithoutIt, QT_TRANSLATE_NOOP("Fault", "Shown without it.")},
      {Consequence::ShownWithoutItUntilTheNext,
       QT_TRANSLATE_NOOP("Fault", "Shown without it. It will be requested again with the next version.")},
      {Consequence::StaysWhereItWas, QT_TRANSLATE_NOOP("Fault", "It stays where it was.")},
      {Consequence::AskedAgain, QT_TRANSLATE_NOOP("Fault", "It will be requested again.")},
      {Consequence::AskedAgainAtTheNext,
       QT_TRANSLATE_NOOP("Fault", "It will be requested again with the next version.")},
      {Consequence::PictureBeforeStays, QT_TRANSLATE_NOOP("Fault", "The previous picture stays.")},
      {Consequence::AlertsBeforeStay, QT_TRANSLATE_NOOP("Fault", "The previous alerts stay.")},
      {Consequence::TheyWereLeftOut, QT_TRANSLATE_NOOP("Fault", "They were left out.")},
      {Consequence::ItsPointsWereLeftOut, QT_TRANSLATE_NOOP("Fault", "Its points were left out.")},
      {Consequence::AskedAgainEachTime, QT_TRANSLATE_NOOP("Fault", "It is requested again each time.")},
      {Consequence::ReadAnewEachTime, QT_TRANSLATE_NOOP("Fault", "They are read again each time.")},
      {Consequence::LeftAsItIs, QT_TRANSLATE_NOOP("Fault", "It is left unchanged.")},
      {Consequence::NothingWritten, QT_TRANSLATE_NOOP("Fault", "Nothing was written.")},
  };
  for (const Text& each : kTexts) {
    if (each.consequence == consequence) return QCoreApplication::translate("Fault", each.text);
  }
  return {};
}

QString wordsOf(const Fault& fault) {
  if (fault.code == robot::fault::CapabilityLacking) return ended(fault, withCauses(fault, lackWords(fault)));
  if (fault.code == fault::Said && fault.arguments.size() == 1)
    return ended(fault, withCauses(fault, saidWords(textOf(fault.arguments.front()))));
  const QString text = QCoreApplication::translate(fault.code.room, fault.code.text, nullptr, countIn(fault));
  if (fault.because.empty() || !text.contains(placeholderAfter(fault.arguments)))
    return ended(fault, withCauses(fault, filled(text, fault.arguments)));
  std::vector<FaultArgument> arguments = fault.arguments;
  arguments.emplace_back(words::withoutStop(wordsOf(fault.because).toStdString()));
  return ended(fault, filled(text, arguments));
}

QString wordsOf(const std::vector<Fault>& faults) {
  QStringList words;
  for (const Fault& fault : faults) words << wordsOf(fault);
  return words::joined(words);
}

QString sentenceOf(const Fault& fault) {
  const QString words = wordsOf(fault);
  QString sentence = words::asSentence(words);
  // A name at its beginning (of a file) is not capitalised.
  const auto* const name =
      fault.arguments.empty() ? nullptr : std::get_if<std::string>(&fault.arguments.front());
  const QString called = name ? QString::fromStdString(*name) : QString();
  const bool begins = !called.isEmpty() && words.startsWith(called) && words.size() > called.size();
  if (begins && fault.code != fault::Said && !sentence.isEmpty()) sentence[0] = called[0];
  return sentence;
}

}  // namespace mapwright::sentences
