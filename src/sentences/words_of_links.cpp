// What is found about the robot and on the way to it.
#include <QCoreApplication>

#include "sentences/words_by_code.h"

namespace mapwright::sentences {
namespace {

using map::ReasonCode;

class WordsOfLinksText {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

// One function for each group of codes.

QString ofTheRobot(ReasonCode code) {
  switch (code) {
    case ReasonCode::AnswersNotKept:
      return WordsOfLinksText::tr("What the robot answers cannot be kept on disk");
    case ReasonCode::MapsNotKept:
      return WordsOfLinksText::tr("What was made of large maps cannot be kept in %1");
    case ReasonCode::DiskMayBeFull:
      return WordsOfLinksText::tr("the disk may be full");
    case ReasonCode::DoesNotSayWhatItIs:
      return WordsOfLinksText::tr("It does not say what it is");
    case ReasonCode::ItAnswered:
      return WordsOfLinksText::tr("It answered: %1");
    case ReasonCode::EmergencyStop:
      return WordsOfLinksText::tr("It is pressed: the robot does not drive until it is released.");
    case ReasonCode::PositionLost:
      return WordsOfLinksText::tr("Where the robot stands on the map may be wrong.");
    case ReasonCode::WheelsReleased:
      return WordsOfLinksText::tr("The robot can be pushed, and rolls on a slope.");
    case ReasonCode::ManualControl:
      return WordsOfLinksText::tr("The robot does not drive by itself.");
    case ReasonCode::PositionUncertain:
      return WordsOfLinksText::tr("The robot may stand beside its place on the map.");
    case ReasonCode::WheelsSlipping:
      return WordsOfLinksText::tr("The robot may not be where its wheels say.");
    case ReasonCode::AlertWithoutText:
      return WordsOfLinksText::tr("The robot gives no text with it.");
    case ReasonCode::BagWithoutTimes:
      return WordsOfLinksText::tr("the answer does not say when it begins and ends");
    case ReasonCode::BagWithoutMessages:
      return WordsOfLinksText::tr("the answer holds no list of messages");
    case ReasonCode::BagNotAsked:
      return WordsOfLinksText::tr("%1 is no range of time");
    case ReasonCode::BagFileNotWritten:
      return WordsOfLinksText::tr("%1 cannot be written: %2");
    case ReasonCode::BagFileOfOtherSize:
      return WordsOfLinksText::tr("%1 bytes came, and the robot says that it has %2");
    default:
      return {};
  }
}

QString ofLinks(ReasonCode code) {
  switch (code) {
    case ReasonCode::RequestCancelled:
      return WordsOfLinksText::tr("cancelled");
    case ReasonCode::NoWebAddress:
      return WordsOfLinksText::tr("the address is not one of a web server");
    case ReasonCode::ConnectionRefused:
      return WordsOfLinksText::tr("connection refused by %1");
    case ReasonCode::HostUnknown:
      return WordsOfLinksText::tr("the host %1 is not known");
    case ReasonCode::ConnectionClosed:
      return WordsOfLinksText::tr("the robot closed the connection");
    case ReasonCode::ConnectionClosedSaying:
      return WordsOfLinksText::tr("the robot closed the connection: %1");
    case ReasonCode::ConnectionBroke:
      return WordsOfLinksText::tr("the connection to %1 broke off");
    case ReasonCode::ConnectionNotSecure:
      return WordsOfLinksText::tr(
          "no secure connection to %1 can be made; it may not be encrypted there (http): %2");
    case ReasonCode::HostSilent:
      return WordsOfLinksText::tr("%1 does not answer");
    case ReasonCode::HostNotReached:
      return WordsOfLinksText::tr("%1 cannot be reached: %2");
    case ReasonCode::NoAnswerWithin:
      return WordsOfLinksText::tr("no answer for %1");
    case ReasonCode::LeadsToAnotherServer:
      return WordsOfLinksText::tr("the robot points to another server, %1, which is not followed");
    case ReasonCode::LeadsToAnotherAddress:
      return WordsOfLinksText::tr("the robot points to another address, which is not followed");
    case ReasonCode::LeadsInCircles:
      return WordsOfLinksText::tr("the robot points from one address to the next without end");
    case ReasonCode::AnswerTooLong:
      return WordsOfLinksText::tr("the answer is longer than the %1 bytes allowed");
    case ReasonCode::AnswerBrokeOff:
      return WordsOfLinksText::tr("the answer broke off after %1 bytes");
    case ReasonCode::AnswerBrokeOffEarly:
      return WordsOfLinksText::tr("the answer broke off after %1 of %2 bytes");
    case ReasonCode::AnsweredWithStatus:
      return WordsOfLinksText::tr("the robot answered %1");
    case ReasonCode::AnsweredWithStatusSaying:
      return WordsOfLinksText::tr("the robot answered %1: %2");
    case ReasonCode::NoAddressToConnectTo:
      return WordsOfLinksText::tr("there is no address to connect to");
    case ReasonCode::NoWebSocketThere:
      return WordsOfLinksText::tr("%1 does not answer as a WebSocket");
    case ReasonCode::ClosedBeforeOpen:
      return WordsOfLinksText::tr("the robot closed the connection before it was open");
    case ReasonCode::BrokeBeforeOpen:
      return WordsOfLinksText::tr("the connection to %1 broke off before it was open");
    case ReasonCode::ConnectionForbidden:
      return WordsOfLinksText::tr("the robot refuses the connection: %1; the secret may be missing or wrong");
    case ReasonCode::ConnectionRejected:
      return WordsOfLinksText::tr("the robot refused the connection: %1");
    case ReasonCode::MessageTooLong:
      return WordsOfLinksText::tr("a message was longer than the %1 bytes allowed");
    case ReasonCode::NoAutoxingRobotThere:
      return WordsOfLinksText::tr(
          "something answers at %1, but not as an Autoxing robot: %2. Check the address and the port.");
    case ReasonCode::NoAgibotRobotThere:
      return WordsOfLinksText::tr(
          "a web server answers there, but it knows no calls of Agibot robots (%1): check the address and "
          "the port");
    default:
      return {};
  }
}

QString ofCertificates(ReasonCode code) {
  switch (code) {
    case ReasonCode::CertificateUntrusted:
      return WordsOfLinksText::tr("the certificate of %1 is not trusted: %3. Its SHA-256 fingerprint: %2");
    case ReasonCode::CertificateChanged:
      return WordsOfLinksText::tr("the certificate of %1 has changed. Trusted (SHA-256): %2. Now: %3");
    case ReasonCode::SelfSigned:
      return WordsOfLinksText::tr("it is self-signed");
    case ReasonCode::AuthorityUnnamed:
      return WordsOfLinksText::tr("it is issued by an authority that is not known here");
    case ReasonCode::AuthorityUnknown:
      return WordsOfLinksText::tr("it is issued by %1, which is not known here");
    case ReasonCode::CertificateExpired:
      return WordsOfLinksText::tr("it has expired on %1");
    case ReasonCode::AuthorityExpired:
      return WordsOfLinksText::tr("its authority has expired on %1");
    case ReasonCode::CertificateNotYetValid:
      return WordsOfLinksText::tr("it is valid from %1 on only, by the clock of this computer");
    case ReasonCode::CertificateOfOtherName:
      return WordsOfLinksText::tr("it is issued for another name (%1)");
    case ReasonCode::CertificateWithoutName:
      return WordsOfLinksText::tr("it is issued for another name (no name)");
    case ReasonCode::CertificateWithdrawn:
      return WordsOfLinksText::tr("it was withdrawn");
    case ReasonCode::CertificateIsAnother:
      return WordsOfLinksText::tr("it is not the one that was trusted");
    case ReasonCode::AuthoritiesNotRead:
      return WordsOfLinksText::tr("The certificate file %1 cannot be read: %2.");
    case ReasonCode::NoAuthoritiesInFile:
      return WordsOfLinksText::tr(
          "The certificate file %1 holds no certificate in PEM form (-----BEGIN CERTIFICATE-----).");
    default:
      return {};
  }
}

}  // namespace

QString wordsOfLinks(ReasonCode code, int /*count*/) {
  QString text;
  if (text.isEmpty()) text = ofTheRobot(code);
  if (text.isEmpty()) text = ofLinks(code);
  if (text.isEmpty()) text = ofCertificates(code);
  return text;
}

}  // namespace mapwright::sentences
