// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include <QStringList>

#include "fault/fault.h"

namespace mapwright::net::fault {

using namespace mapwright::fault;  // what all rooms share

// What goes over the network. Hosts come with their ports.
inline constexpr FaultCode RequestCancelled{"net", QT_TRANSLATE_NOOP("net", "cancelled")};
inline constexpr FaultCode NoWebAddress{"net",
                                        QT_TRANSLATE_NOOP("net", "this is not the address of a web server")};
/// host
inline constexpr FaultCode ConnectionRefused{"net", QT_TRANSLATE_NOOP("net", "connection refused by %1")};
/// name
inline constexpr FaultCode HostUnknown{"net", QT_TRANSLATE_NOOP("net", "the host %1 is unknown")};
inline constexpr FaultCode ConnectionClosed{"net",
                                            QT_TRANSLATE_NOOP("net", "the robot closed the connection")};
/// the robot's words
inline constexpr FaultCode ConnectionClosedSaying{
    "net", QT_TRANSLATE_NOOP("net", "the robot closed the connection: %1")};
/// host
inline constexpr FaultCode ConnectionBroke{"net", QT_TRANSLATE_NOOP("net", "the connection to %1 was lost")};
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
inline constexpr FaultCode LeadsToAnotherAddress{
    "net", QT_TRANSLATE_NOOP("net", "the robot redirects to another address, which is not followed")};
inline constexpr FaultCode LeadsInCircles{"net", QT_TRANSLATE_NOOP("net", "the robot redirects without end")};
/// bytes
inline constexpr FaultCode AnswerBrokeOff{"net",
                                          QT_TRANSLATE_NOOP("net", "the answer was cut off after %1 bytes")};
/// bytes, of how many
inline constexpr FaultCode AnswerBrokeOffEarly{
    "net", QT_TRANSLATE_NOOP("net", "the answer was cut off after %1 of %2 bytes")};
/// HTTP status
inline constexpr FaultCode AnsweredWithStatus{"net", QT_TRANSLATE_NOOP("net", "the robot answered %1")};
/// HTTP status, the robot's words
inline constexpr FaultCode AnsweredWithStatusSaying{"net",
                                                    QT_TRANSLATE_NOOP("net", "the robot answered %1: %2")};
inline constexpr FaultCode NoAddressToConnectTo{
    "net", QT_TRANSLATE_NOOP("net", "there is no address to connect to")};
/// host
inline constexpr FaultCode NoWebSocketThere{"net",
                                            QT_TRANSLATE_NOOP("net", "%1 does not answer as a WebSocket")};
inline constexpr FaultCode ClosedBeforeOpen{
    "net", QT_TRANSLATE_NOOP("net", "the robot closed the connection before it was established")};
/// host
inline constexpr FaultCode BrokeBeforeOpen{
    "net", QT_TRANSLATE_NOOP("net", "the connection to %1 was lost before it was established")};
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
/// path
inline constexpr FaultCode FolderNotMade{"net", QT_TRANSLATE_NOOP("net", "the folder %1 cannot be created")};
/// path, the system's words
inline constexpr FaultCode FileNotRemoved{"net", QT_TRANSLATE_NOOP("net", "%1 cannot be removed: %2")};
/// path, the system's words
inline constexpr FaultCode FileNotKept{"net", QT_TRANSLATE_NOOP("net", "%1 cannot be written: %2")};

// Certificates. Days are texts.
/// host, SHA-256; because: why
inline constexpr FaultCode CertificateUntrusted{
    "net", QT_TRANSLATE_NOOP("net", "the certificate of %1 is not trusted: %3. Its SHA-256 fingerprint: %2")};
/// host, SHA-256 of the trusted one, of the present one
inline constexpr FaultCode CertificateChanged{
    "net", QT_TRANSLATE_NOOP("net", "the certificate of %1 has changed. Trusted (SHA-256): %2. Now: %3")};
inline constexpr FaultCode SelfSigned{"net", QT_TRANSLATE_NOOP("net", "it is self-signed")};
inline constexpr FaultCode AuthorityUnnamed{
    "net", QT_TRANSLATE_NOOP("net", "it was issued by an unknown authority")};
/// its name
inline constexpr FaultCode AuthorityUnknown{
    "net", QT_TRANSLATE_NOOP("net", "it was issued by %1, which is not trusted here")};
/// day
inline constexpr FaultCode CertificateExpired{"net", QT_TRANSLATE_NOOP("net", "it expired on %1")};
/// day
inline constexpr FaultCode AuthorityExpired{
    "net", QT_TRANSLATE_NOOP("net", "the certificate of its authority expired on %1")};
/// day
inline constexpr FaultCode CertificateNotYetValid{
    "net", QT_TRANSLATE_NOOP("net", "it is not valid before %1, by the clock of this computer")};
/// name
inline constexpr FaultCode CertificateOfOtherName{
    "net", QT_TRANSLATE_NOOP("net", "it was issued for another name (%1)")};
inline constexpr FaultCode CertificateWithoutName{"net",
                                                  QT_TRANSLATE_NOOP("net", "it was issued without a name")};
inline constexpr FaultCode CertificateWithdrawn{"net", QT_TRANSLATE_NOOP("net", "it was revoked")};
inline constexpr FaultCode CertificateIsAnother{"net", QT_TRANSLATE_NOOP("net", "it is not the trusted one")};
/// path, the system's words
inline constexpr FaultCode AuthoritiesNotRead{
    "net", QT_TRANSLATE_NOOP("net", "The certificate file %1 cannot be read: %2.")};
/// path
inline constexpr FaultCode NoAuthoritiesInFile{
    "net",
    QT_TRANSLATE_NOOP(
        "net", "The certificate file %1 contains no certificate in PEM form (-----BEGIN CERTIFICATE-----).")};

}  // namespace mapwright::net::fault

namespace mapwright::net {

/// With arguments as Qt has them.
Fault faultOf(const FaultCode& code, const QStringList& arguments);

}  // namespace mapwright::net
