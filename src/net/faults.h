// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include <QStringList>

#include "fault/fault.h"

namespace mapwright::net::fault {

using namespace mapwright::fault;  // what all rooms share

// What goes over the network. Hosts come with their ports.
inline constexpr FaultCode RequestCancelled{"net", QT_TRANSLATE_NOOP("net", "cancelled")};
/// host
inline constexpr FaultCode ConnectionRefused{"net", QT_TRANSLATE_NOOP("net", "connection refused by %1")};
/// name
inline constexpr FaultCode HostUnknown{"net", QT_TRANSLATE_NOOP("net", "the host %1 is unknown")};
inline constexpr FaultCode ConnectionClosed{"net",
                                            QT_TRANSLATE_NOOP("net", "the robot closed the connection")};
/// the robot's words
inline constexpr FaultCode ConnectionClosedSaying{
    "net", QT_TRANSLATE_NOOP("net", "the robot closed the connection: %1")};
/// host, the system's words
inline constexpr FaultCode ConnectionNotSecure{
    "net",
    QT_TRANSLATE_NOOP(
        "net", "no secure connection to %1 could be made; the server may not use encryption (http): %2")};
/// host
inline constexpr FaultCode HostSilent{"net", QT_TRANSLATE_NOOP("net", "%1 does not answer")};
/// host, the system's words
inline constexpr FaultCode HostNotReached{"net", QT_TRANSLATE_NOOP("net", "%1 cannot be reached: %2")};
/// how long, with its unit
inline constexpr FaultCode NoAnswerWithin{"net", QT_TRANSLATE_NOOP("net", "no answer within %1")};
/// host
inline constexpr FaultCode LeadsToAnotherServer{
    "net", QT_TRANSLATE_NOOP("net", "the robot redirects to another server, %1, which is not followed")};
/// HTTP status, the robot's words
inline constexpr FaultCode AnsweredWithStatusSaying{"net",
                                                    QT_TRANSLATE_NOOP("net", "the robot answered %1: %2")};
/// HTTP status
inline constexpr FaultCode ConnectionForbidden{
    "net",
    QT_TRANSLATE_NOOP("net", "the robot refused the connection: %1; the secret may be missing or wrong")};
/// HTTP status
inline constexpr FaultCode ConnectionRejected{
    "net", QT_TRANSLATE_NOOP("net", "the robot refused the connection: %1")};
/// the most bytes
inline constexpr FaultCode MessageTooLong{"net",
                                          QT_TRANSLATE_NOOP("net", "a message exceeds the %1 bytes allowed")};

// Certificates. Days are texts.
/// host, SHA-256; because: why
inline constexpr FaultCode CertificateUntrusted{
    "net", QT_TRANSLATE_NOOP("net", "the certificate of %1 is not trusted: %3. Its SHA-256 fingerprint: %2")};
/// host, SHA-256 of the trusted one, of the present one
inline constexpr FaultCode CertificateChanged{
    "net", QT_TRANSLATE_NOOP("net", "the certificate of %1 has changed. Trusted (SHA-256): %2. Now: %3")};
inline constexpr FaultCode SelfSigned{"net", QT_TRANSLATE_NOOP("net", "it is self-signed")};
/// its name
inline constexpr FaultCode AuthorityUnknown{
    "net", QT_TRANSLATE_NOOP("net", "it was issued by %1, which is not trusted here")};
/// day
inline constexpr FaultCode CertificateExpired{"net", QT_TRANSLATE_NOOP("net", "it expired on %1")};
/// day
inline constexpr FaultCode CertificateNotYetValid{
    "net", QT_TRANSLATE_NOOP("net", "it is not valid before %1, by the clock of this computer")};
/// name
inline constexpr FaultCode CertificateOfOtherName{
    "net", QT_TRANSLATE_NOOP("net", "it was issued for another name (%1)")};
inline constexpr FaultCode CertificateWithdrawn{"net", QT_TRANSLATE_NOOP("net", "it was revoked")};
inline constexpr FaultCode CertificateIsAnother{"net", QT_TRANSLATE_NOOP("net", "it is not the trusted one")};

}  // namespace mapwright::net::fault

namespace mapwright::net {

/// With arguments as Qt has them.
Fault faultOf(const FaultCode& code, const QStringList& arguments);

}  // namespace mapwright::net
