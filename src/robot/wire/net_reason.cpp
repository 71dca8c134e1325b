#include "robot/wire/net_reason.h"

namespace mapwright::robot::wire {
namespace {

map::ReasonCode codeOf(net::ReasonCode code) {
  using From = net::ReasonCode;
  using To = map::ReasonCode;
  switch (code) {
    case From::None:
      return To::None;
    case From::Said:
      return To::Said;
    case From::RequestCancelled:
      return To::RequestCancelled;
    case From::NoWebAddress:
      return To::NoWebAddress;
    case From::ConnectionRefused:
      return To::ConnectionRefused;
    case From::HostUnknown:
      return To::HostUnknown;
    case From::ConnectionClosed:
      return To::ConnectionClosed;
    case From::ConnectionClosedSaying:
      return To::ConnectionClosedSaying;
    case From::ConnectionBroke:
      return To::ConnectionBroke;
    case From::ConnectionNotSecure:
      return To::ConnectionNotSecure;
    case From::HostSilent:
      return To::HostSilent;
    case From::HostNotReached:
      return To::HostNotReached;
    case From::NoAnswerWithin:
      return To::NoAnswerWithin;
    case From::LeadsToAnotherServer:
      return To::LeadsToAnotherServer;
    case From::LeadsToAnotherAddress:
      return To::LeadsToAnotherAddress;
    case From::LeadsInCircles:
      return To::LeadsInCircles;
    case From::AnswerTooLong:
      return To::AnswerTooLong;
    case From::AnswerBrokeOff:
      return To::AnswerBrokeOff;
    case From::AnswerBrokeOffEarly:
      return To::AnswerBrokeOffEarly;
    case From::AnsweredWithStatus:
      return To::AnsweredWithStatus;
    case From::AnsweredWithStatusSaying:
      return To::AnsweredWithStatusSaying;
    case From::NoAddressToConnectTo:
      return To::NoAddressToConnectTo;
    case From::NoWebSocketThere:
      return To::NoWebSocketThere;
    case From::ClosedBeforeOpen:
      return To::ClosedBeforeOpen;
    case From::BrokeBeforeOpen:
      return To::BrokeBeforeOpen;
    case From::ConnectionForbidden:
      return To::ConnectionForbidden;
    case From::ConnectionRejected:
      return To::ConnectionRejected;
    case From::MessageTooLong:
      return To::MessageTooLong;
    case From::FolderNotMade:
      return To::FolderNotMade;
    case From::FileNotRemoved:
      return To::FileNotRemoved;
    case From::FileNotKept:
      return To::FileNotKept;
    case From::CertificateUntrusted:
      return To::CertificateUntrusted;
    case From::CertificateChanged:
      return To::CertificateChanged;
    case From::SelfSigned:
      return To::SelfSigned;
    case From::AuthorityUnnamed:
      return To::AuthorityUnnamed;
    case From::AuthorityUnknown:
      return To::AuthorityUnknown;
    case From::CertificateExpired:
      return To::CertificateExpired;
    case From::AuthorityExpired:
      return To::AuthorityExpired;
    case From::CertificateNotYetValid:
      return To::CertificateNotYetValid;
    case From::CertificateOfOtherName:
      return To::CertificateOfOtherName;
    case From::CertificateWithoutName:
      return To::CertificateWithoutName;
    case From::CertificateWithdrawn:
      return To::CertificateWithdrawn;
    case From::CertificateIsAnother:
      return To::CertificateIsAnother;
    case From::AuthoritiesNotRead:
      return To::AuthoritiesNotRead;
    case From::NoAuthoritiesInFile:
      return To::NoAuthoritiesInFile;
  }
  return To::None;
}

}  // namespace

map::Reason reasonOf(const net::Reason& reason) {
  map::Reason made(codeOf(reason.code));
  if (reason.status != 0) made.arguments.emplace_back(std::int64_t(reason.status));
  for (const QString& argument : reason.arguments) made.arguments.emplace_back(argument.toStdString());
  for (const net::Reason& cause : reason.because) made.because.push_back(reasonOf(cause));
  return made;
}

}  // namespace mapwright::robot::wire
