#include "sentences/failure_sentence.h"

#include <QCoreApplication>
#include <QString>

#include "sentences/http_status.h"
#include "sentences/reason_sentence.h"
#include "words/sentences.h"

namespace mapwright::sentences {
namespace {

using map::Applied;
using map::AskedFor;
using map::Failure;
using map::FailureKind;
using map::FailureReason;
using map::SubjectKind;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Failure)
};

/// What is wrong, in the words of a finder or of somebody else.
std::string toldBy(const Failure& failure) {
  return failure.cause.any() ? wordsOf(failure.cause).toStdString() : failure.detail;
}

QString changeFailed(const Failure& failure) {
  switch (failure.applied) {
    case Applied::No:
      return Words::tr("It has not been changed");
    case Applied::Maybe:
      return Words::tr("Whether it has been changed is not known");
    case Applied::Yes:
      break;
  }
  return Words::tr("It has been changed, but the robot's answer is lost");
}

QString pictureFailed(const Failure& failure) {
  const bool small = failure.asked_for == AskedFor::SmallPicture;
  if (failure.reason == FailureReason::Empty)
    return small ? Words::tr("Its small picture is empty") : Words::tr("Its picture is empty");
  return small ? Words::tr("Its small picture cannot be had") : Words::tr("Its picture cannot be had");
}

/// What has not come about, without its reason.
QString opening(const Failure& failure) {
  if (failure.asked_for == AskedFor::Change) return changeFailed(failure);
  if (failure.asked_for != AskedFor::All) return pictureFailed(failure);
  const bool read = map::isUnreadable(failure);
  switch (failure.subject.kind) {
    case SubjectKind::Catalogue:
      return read ? Words::tr("The list cannot be read") : Words::tr("The list cannot be had");
    case SubjectKind::Places:
      return read ? Words::tr("Its points cannot be read") : Words::tr("Its points cannot be had");
    case SubjectKind::Overview:
      return read ? Words::tr("The overview of the map cannot be read")
                  : Words::tr("The overview of the map cannot be had");
    default:
      return read ? Words::tr("It cannot be read") : Words::tr("It cannot be had");
  }
}

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

/// "the robot answered 404 (not found): No such map".
QString robotSaid(const Failure& failure) {
  const QString code = text(failure.robot_code);
  const int status = code.size() == 3 ? code.toInt() : 0;
  const QString answer = status >= 300    ? Words::tr("the robot answered %1").arg(statusWords(status))
                         : code.isEmpty() ? Words::tr("the robot refuses")
                                          : Words::tr("the robot refuses (code %1)").arg(code);
  const std::string why = toldBy(failure);
  if (why.empty()) return answer;
  return QStringLiteral("%1: %2").arg(answer, text(words::withoutStop(why)));
}

QString reasonOf(const Failure& failure) {
  switch (failure.kind) {
    case FailureKind::RejectedByRobot:
    case FailureKind::Refused:
    case FailureKind::Conflict:
      return robotSaid(failure);
    case FailureKind::Cancelled:
      return Words::tr("it was cancelled");
    default:
      return text(toldBy(failure));
  }
}

/// What can be said where nobody has said anything.
QString kindOf(const Failure& failure) {
  switch (failure.kind) {
    case FailureKind::Unreachable:
      return Words::tr("the connection is gone");
    case FailureKind::TimedOut:
      return Words::tr("no answer came in time");
    case FailureKind::Conflict:
      return Words::tr("somebody else has changed it meanwhile");
    default:
      return Words::tr("it did not work");
  }
}

QString notThere(const Failure& failure) {
  return failure.subject.kind == SubjectKind::Map ? Words::tr("There is no such map.")
                                                  : Words::tr("There is no such thing.");
}

QString notOffered(const Failure& failure) {
  if (failure.asked_for == AskedFor::SmallPicture)
    return Words::tr("There are no small pictures of maps here.");
  if (failure.asked_for == AskedFor::Change) return Words::tr("It cannot be changed from here.");
  return Words::tr("This robot offers nothing of the kind.");
}

QString textOf(const Failure& failure) {
  switch (failure.reason) {
    case FailureReason::Unfit:
      return text(words::asSentence(toldBy(failure)));
    case FailureReason::NotThere:
      return notThere(failure);
    case FailureReason::NotOffered:
      return notOffered(failure);
    case FailureReason::NoSuchId:
      return Words::tr("It cannot be asked for by this id. Ids look like %1.")
          .arg(failure.arguments.empty() ? QString() : text(failure.arguments.front()));
    case FailureReason::Empty:
    case FailureReason::Told:
      break;
  }
  return text(words::because(opening(failure).toStdString(), reasonOf(failure).toStdString()));
}

}  // namespace

std::string sentenceOf(const map::Failure& failure) { return textOf(failure).toStdString(); }

std::string whyOf(const map::Failure& failure) {
  const bool told = failure.reason == FailureReason::Told || failure.reason == FailureReason::Empty;
  // Who was overtaken has not been refused by anybody.
  QString why = failure.kind == FailureKind::Conflict ? text(toldBy(failure))
                : told                                ? reasonOf(failure)
                                                      : textOf(failure);
  if (why.isEmpty()) why = kindOf(failure);
  return words::asSentence(why.toStdString());
}

}  // namespace mapwright::sentences
