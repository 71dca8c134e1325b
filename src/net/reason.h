// Why something on the network did not come about, as a value. What people read of it is made elsewhere
// (robot::wire::reasonOf, sentences::wordsOf).
#pragma once

#include <utility>
#include <vector>

#include <QString>
#include <QStringList>

namespace mapwright::net {

/// Behind each: its arguments. Hosts come with their ports ("10.0.0.7:8090").
enum class ReasonCode {
  None,
  Said,  // the words of somebody else: the system, a library
  RequestCancelled,
  NoWebAddress,
  ConnectionRefused,  // host
  HostUnknown,        // its name
  ConnectionClosed,
  ConnectionClosedSaying,  // the robot's words
  ConnectionBroke,         // host
  ConnectionNotSecure,     // host, the system's words
  HostSilent,              // host
  HostNotReached,          // host, the system's words
  NoAnswerWithin,          // how long, with its unit
  LeadsToAnotherServer,    // host
  LeadsToAnotherAddress,
  LeadsInCircles,
  AnswerTooLong,             // the most bytes
  AnswerBrokeOff,            // bytes
  AnswerBrokeOffEarly,       // bytes, of how many
  AnsweredWithStatus,        // status
  AnsweredWithStatusSaying,  // status; the robot's words
  // Of a WebSocket.
  NoAddressToConnectTo,
  NoWebSocketThere,  // host
  ClosedBeforeOpen,
  BrokeBeforeOpen,      // host
  ConnectionForbidden,  // status
  ConnectionRejected,   // status
  MessageTooLong,       // the most bytes
  // Of the cache.
  FolderNotMade,   // path
  FileNotRemoved,  // path, the system's words
  FileNotKept,     // path, the system's words
  // Of certificates.
  CertificateUntrusted,  // host, SHA-256; because: why
  CertificateChanged,    // host, SHA-256 of the trusted one, of the present one
  SelfSigned,
  AuthorityUnnamed,
  AuthorityUnknown,        // its name
  CertificateExpired,      // day
  AuthorityExpired,        // day
  CertificateNotYetValid,  // day
  CertificateOfOtherName,  // name
  CertificateWithoutName,
  CertificateWithdrawn,
  CertificateIsAnother,
  AuthoritiesNotRead,   // path, the system's words
  NoAuthoritiesInFile,  // path
};

/// Arguments are plain text of at most kMaxSentence characters on one line (net/plain_sentences.h), never
/// markup, and hold no secret.
struct Reason {
  ReasonCode code = ReasonCode::None;
  QStringList arguments;
  int status = 0;               // HTTP status, of the codes that name one
  std::vector<Reason> because;  // what lies behind it

  Reason() = default;
  Reason(ReasonCode its_code, QStringList its_arguments = {}, int its_status = 0)
      : code(its_code), arguments(std::move(its_arguments)), status(its_status) {}
  bool any() const { return code != ReasonCode::None; }
  bool operator==(const Reason&) const = default;
};

}  // namespace mapwright::net
