// Which certificates an encrypted connection to one robot is made with, and why one is not accepted.
#pragma once

#include <optional>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QList>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QSslError>
#include <QString>
#include <QUrl>
#include <tl/expected.hpp>

#include "net/faults.h"

namespace mapwright::net {

/// Whom to believe. Holds for one origin.
struct Trust {
  QList<QSslCertificate> authorities;  // empty: those that this computer knows
  /// SHA-256 of the robot's own certificate (32 bytes). When set, exactly this one is accepted, whatever else
  /// would be held against it, and no other, whoever vouches for it.
  QByteArray pinned_sha256;
};

/// Why a certificate is not accepted.
struct CertificateFault {
  enum class Reason {
    SelfSigned,
    UnknownAuthority,
    Expired,
    NotYetValid,
    OtherName,
    Changed,
    Revoked,
    Other
  };
  QList<Reason> reasons;    // never empty
  QString host;             // "10.0.0.7:8443"
  std::vector<Fault> whys;  // one of each of them, with its arguments: its day, a name
  QByteArray sha256, pinned_sha256;
  QString subject, issuer;  // untrusted plain text
  QDateTime from, until;
  /// May the user decide to trust it all the same? Not when it was withdrawn or there is none.
  bool trustable() const;
};

/// "AB:CD:…", as `openssl x509 -fingerprint -sha256` prints it.
QString fingerprintText(const QByteArray& sha256);
/// The reverse; blanks and colons do not matter. Empty when it is not 32 bytes.
QByteArray fingerprintFrom(const QString& text);
/// CertificateUntrusted or CertificateChanged, with its fingerprints.
Fault reasonOf(const CertificateFault& fault);

/// What to connect with. A pinned certificate is judged by acceptable() alone: no authority is asked then.
QSslConfiguration configurationFor(const Trust& trust);
/// Judges `errors`, found with the certificate of `url`: nullopt = go on, and ignore exactly these.
std::optional<CertificateFault> faultOf(const Trust& trust, const QSslCertificate& leaf,
                                        const QList<QSslError>& errors, const QUrl& url);

/// The certificates of a PEM file.
tl::expected<QList<QSslCertificate>, Fault> readAuthorities(const QString& file);

}  // namespace mapwright::net
