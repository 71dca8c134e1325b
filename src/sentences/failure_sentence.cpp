#include "sentences/failure_sentence.h"

#include <QCoreApplication>
#include <QString>

#include "sentences/fault_sentence.h"
#include "sentences/http_status.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::sentences {
namespace {

using map::Applied;
using map::AskedFor;
using map::Failure;
using map::FailureKind;
using map::FailureReason;
using map::SubjectKind;

class FailureText {
  Q_DECLARE_TR_FUNCTIONS(Failure)
};

/// What is wrong, as described by the finder or the robot.
std::string toldBy(const Failure& failure) {
  return failure.cause.any() ? wordsOf(failure.cause).toStdString() : failure.detail;
}

QString changeFailed(const Failure& failure) {
  const bool addition = failure.asked_for == AskedFor::Addition;
  if (addition || failure.asked_for == AskedFor::Action) {
    switch (failure.applied) {
      case Applied::No:
        return addition ? FailureText::tr("It was not added") : FailureText::tr("It was not done");
      case Applied::Maybe:
        return addition ? FailureText::tr("Whether it was added is unknown")
                        : FailureText::tr("Whether it was done is unknown");
      case Applied::Yes:
        break;
    }
    return addition ? FailureText::tr("It was added, but cannot be read back")
                    : FailureText::tr("It was done, but the robot's answer was lost");
  }
  switch (failure.applied) {
    case Applied::No:
      return FailureText::tr("It was not changed");
    case Applied::Maybe:
      return FailureText::tr("Whether it was changed is unknown");
    case Applied::Yes:
      break;
  }
  return FailureText::tr("It was changed, but the robot's answer was lost");
}

QString pictureFailed(const Failure& failure) {
  const bool small = failure.asked_for == AskedFor::SmallPicture;
  if (failure.reason == FailureReason::Empty)
    return small ? FailureText::tr("Its thumbnail is empty") : FailureText::tr("Its picture is empty");
  return small ? FailureText::tr("Its thumbnail cannot be loaded")
               : FailureText::tr("Its picture cannot be loaded");
}

/// What did not work, without the reason.
QString opening(const Failure& failure) {
  if (map::changes(failure.asked_for)) return changeFailed(failure);
  if (failure.asked_for != AskedFor::All) return pictureFailed(failure);
  const bool read = map::isUnreadable(failure);
  switch (failure.subject.kind) {
    case SubjectKind::Catalogue:
      return read ? FailureText::tr("The list cannot be read") : FailureText::tr("The list cannot be loaded");
    case SubjectKind::Places:
      return read ? FailureText::tr("Its points cannot be read")
                  : FailureText::tr("Its points cannot be loaded");
    case SubjectKind::Overview:
      return read ? FailureText::tr("The overview of the map cannot be read")
                  : FailureText::tr("The overview of the map cannot be loaded");
    default:
      return read ? FailureText::tr("It cannot be read") : FailureText::tr("It cannot be loaded");
  }
}

using words::text;

/// "the robot answered 404 (not found): No such map".
QString robotSaid(const Failure& failure) {
  const QString code = text(failure.robot_code);
  const int status = code.size() == 3 ? code.toInt() : 0;
  const QString answer = status >= 300    ? FailureText::tr("the robot answered %1").arg(statusWords(status))
                         : code.isEmpty() ? FailureText::tr("the robot refused")
                                          : FailureText::tr("the robot refused (code %1)").arg(code);
  const std::string why = toldBy(failure);
  if (why.empty()) return answer;
  return words::about(answer, text(words::withoutStop(why)));
}

QString reasonOf(const Failure& failure) {
  switch (failure.kind) {
    case FailureKind::RejectedByRobot:
    case FailureKind::Refused:
    case FailureKind::Conflict:
      return robotSaid(failure);
    case FailureKind::Cancelled:
      return FailureText::tr("it was cancelled");
    default:
      return text(toldBy(failure));
  }
}

/// A generic reason if there is no other.
QString kindOf(const Failure& failure) {
  switch (failure.kind) {
    case FailureKind::Unreachable:
      return FailureText::tr("the connection was lost");
    case FailureKind::TimedOut:
      return FailureText::tr("no answer came in time");
    case FailureKind::Conflict:
      return FailureText::tr("someone else changed it in the meantime");
    default:
      return FailureText::tr("it failed");
  }
}

QString notThere(const Failure& failure) {
  return failure.subject.kind == SubjectKind::Map ? FailureText::tr("There is no such map.")
                                                  : FailureText::tr("There is no such object.");
}

QString notOffered(const Failure& failure) {
  if (failure.asked_for == AskedFor::SmallPicture)
    return FailureText::tr("There are no thumbnails of maps here.");
  if (map::changes(failure.asked_for)) return FailureText::tr("It cannot be changed from here.");
  return FailureText::tr("This robot does not offer this.");
}

QString textOf(const Failure& failure) {
  switch (failure.reason) {
    case FailureReason::Unfit:
      return words::asSentence(text(toldBy(failure)));
    case FailureReason::NotThere:
      return notThere(failure);
    case FailureReason::NotOffered:
      return notOffered(failure);
    case FailureReason::NoSuchId:
      return FailureText::tr("This is not a valid id. Ids look like %1.")
          .arg(failure.arguments.empty() ? QString() : text(failure.arguments.front()));
    case FailureReason::Empty:
    case FailureReason::Told:
      break;
  }
  return words::because(opening(failure), reasonOf(failure));
}

}  // namespace

std::string sentenceOf(const map::Failure& failure) { return textOf(failure).toStdString(); }

std::string failureReason(const map::Failure& failure) {
  const bool told = failure.reason == FailureReason::Told || failure.reason == FailureReason::Empty;
  // A conflict is not a refusal.
  QString why = failure.kind == FailureKind::Conflict ? text(toldBy(failure))
                : told                                ? reasonOf(failure)
                                                      : textOf(failure);
  if (why.isEmpty()) why = kindOf(failure);
  return words::asSentence(why).toStdString();
}

}  // namespace mapwright::sentences
