#include "sentences/reason_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "sentences/absence_sentence.h"
#include "sentences/http_status.h"
#include "sentences/plural.h"
#include "sentences/words_by_code.h"
#include "words/sentences.h"

namespace mapwright::sentences {
namespace {

using map::Consequence;
using map::Reason;
using map::ReasonCode;

class ReasonSentenceText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

QString textOf(const map::Argument& argument) {
  if (const auto* const whole = std::get_if<std::int64_t>(&argument)) return QString::number(*whole);
  if (const auto* const number = std::get_if<double>(&argument)) return QString::number(*number, 'g', 6);
  return QString::fromStdString(std::get<std::string>(argument));
}

/// What the sentence counts, where it counts anything: a number, or one that is grouped.
int countIn(const Reason& reason) {
  constexpr int kMany = 2;
  if (reason.arguments.empty()) return kMany;
  if (const auto* const count = std::get_if<std::int64_t>(&reason.arguments[0])) return formOf(*count);
  const auto* const text = std::get_if<std::string>(&reason.arguments[0]);
  bool is_number = false;
  const qint64 count =
      text ? QString::fromStdString(*text).remove(QLatin1Char(',')).toLongLong(&is_number) : 0;
  return is_number ? formOf(count) : kMany;
}

bool isAboutAStatus(ReasonCode code) {
  return code == ReasonCode::AnsweredWithStatus || code == ReasonCode::AnsweredWithStatusSaying ||
         code == ReasonCode::ConnectionForbidden || code == ReasonCode::ConnectionRejected;
}

QString placeAfter(const std::vector<map::Argument>& arguments) {
  return QLatin1Char('%') + QString::number(arguments.size() + 1);
}

/// Arguments are put in at once: what they hold is no template.
QString filled(const QString& text, const std::vector<map::Argument>& arguments) {
  QString full;
  full.reserve(text.size());
  for (qsizetype i = 0; i < text.size(); ++i) {
    const int place = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
    if (place < 1) {
      full += text[i];
      continue;
    }
    ++i;
    if (std::size_t(place) <= arguments.size()) full += textOf(arguments[std::size_t(place) - 1]);
  }
  return full;
}

QString lackWords(const Reason& reason) {
  robot::Absence absence;
  const auto number = [&](std::size_t at) {
    const auto* const given =
        at < reason.arguments.size() ? std::get_if<std::int64_t>(&reason.arguments[at]) : nullptr;
    return given ? int(*given) : 0;
  };
  absence.reason = robot::Absence::Reason(number(1));
  for (std::size_t i = 2; i < reason.arguments.size(); ++i)
    absence.arguments.push_back(textOf(reason.arguments[i]).toStdString());
  return whyAbsent(robot::Capability(number(0)), absence);
}

/// Whether it names the frame that its own does not fit; no such frame is known where it does not.
bool namesOtherFrame(const Reason& reason) {
  if (reason.code == ReasonCode::RosFramesApart) return reason.arguments.size() != 1;
  return reason.code != ReasonCode::WaypointInOtherFrame || reason.arguments.size() != 2;
}

std::string causesOf(const Reason& reason) { return wordsOf(reason.because).toStdString(); }

QString withCauses(const Reason& reason, const QString& text) {
  if (reason.because.empty()) return text;
  const std::string causes = causesOf(reason);
  switch (reason.code) {
    case ReasonCode::OneSlice:  // goes on in a sentence of others
      return QStringLiteral("%1: %2").arg(text, QString::fromStdString(causes));
    case ReasonCode::Slices:
      return QString::fromStdString(words::asSentence(causes));
    case ReasonCode::PictureNotReadable:
      return text + QLatin1Char(' ') + QString::fromStdString(words::asSentence(causes));
    case ReasonCode::VersionNotHad:
      return QString::fromStdString(words::because(text.toStdString(), words::asSentence(causes)));
    default:
      return QString::fromStdString(words::because(text.toStdString(), causes));
  }
}

/// With what follows from it.
QString ended(const Reason& reason, const QString& whole) {
  if (reason.then == Consequence::None || whole.isEmpty()) return whole + consequenceOf(reason.then);
  QString ended = QString::fromStdString(words::asSentence(whole.toStdString()));
  ended[0] = whole[0];  // it may be a name
  return ended + QLatin1Char(' ') + consequenceOf(reason.then);
}

}  // namespace

QString templateOf(ReasonCode code, int count) {
  if (code == ReasonCode::Said) return QStringLiteral("%1");
  for (const auto words :
       {wordsOfSubmaps, wordsOfMaps, wordsOfFiles, wordsOfLinks, wordsOfRos, wordsOfRecordings}) {
    if (const QString text = words(code, count); !text.isEmpty()) return text;
  }
  return {};  // None, and what is put together otherwise
}

QString consequenceOf(Consequence consequence) {
  switch (consequence) {
    case Consequence::None:
      break;
    case Consequence::ShownWithoutIt:
      return ReasonSentenceText::tr("Shown without it.");
    case Consequence::ShownWithoutItUntilTheNext:
      return ReasonSentenceText::tr("Shown without it. It will be asked for again at the next version.");
    case Consequence::StaysWhereItWas:
      return ReasonSentenceText::tr("It stays where it was.");
    case Consequence::AskedAgain:
      return ReasonSentenceText::tr("It will be asked for again.");
    case Consequence::AskedAgainAtTheNext:
      return ReasonSentenceText::tr("It will be asked for again at the next version.");
    case Consequence::PictureBeforeStays:
      return ReasonSentenceText::tr("The picture before stays.");
    case Consequence::PictureBeforeItStays:
      return ReasonSentenceText::tr("The picture before it stays.");
    case Consequence::AlertsBeforeStay:
      return ReasonSentenceText::tr("The alerts before stay.");
    case Consequence::TheyWereLeftOut:
      return ReasonSentenceText::tr("They were left out.");
    case Consequence::ItsPointsWereLeftOut:
      return ReasonSentenceText::tr("Its points were left out.");
    case Consequence::AskedAgainEachTime:
      return ReasonSentenceText::tr("It is asked for again each time.");
    case Consequence::ReadAnewEachTime:
      return ReasonSentenceText::tr("They are read anew each time.");
    case Consequence::LeftAsItIs:
      return ReasonSentenceText::tr("It is left as it is.");
    case Consequence::NothingWritten:
      return ReasonSentenceText::tr("Nothing was written.");
  }
  return {};
}

QString wordsOf(const Reason& reason) {
  if (reason.code == ReasonCode::CapabilityLacking)
    return ended(reason, withCauses(reason, lackWords(reason)));
  const QString text =
      namesOtherFrame(reason) ? templateOf(reason.code, countIn(reason)) : wordsOfLoneFrame(reason.code);
  std::vector<map::Argument> arguments = reason.arguments;
  if (const auto* const status = arguments.empty() ? nullptr : std::get_if<std::int64_t>(&arguments[0]);
      status && isAboutAStatus(reason.code))
    arguments[0] = statusWords(int(*status)).toStdString();
  if (reason.because.empty() || !text.contains(placeAfter(arguments)))
    return ended(reason, withCauses(reason, filled(text, arguments)));
  arguments.emplace_back(words::withoutStop(causesOf(reason)));
  return ended(reason, filled(text, arguments));
}

QString wordsOf(const std::vector<Reason>& reasons) {
  QStringList words;
  for (const Reason& reason : reasons) words << wordsOf(reason);
  return words.join(QStringLiteral("; "));
}

QString sentenceOf(const Reason& reason) {
  const std::string words = wordsOf(reason).toStdString();
  std::string sentence = words::asSentence(words);
  // A name at its beginning (of a file) stays as it is written.
  const auto* const name =
      reason.arguments.empty() ? nullptr : std::get_if<std::string>(&reason.arguments.front());
  const bool begins = name && !name->empty() && words.starts_with(*name) && words.size() > name->size();
  if (begins && reason.code != ReasonCode::Said && !sentence.empty()) sentence[0] = (*name)[0];
  return QString::fromStdString(sentence);
}

}  // namespace mapwright::sentences
