// Which certificates to accept for encrypted connections to a robot, and why one is rejected.
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

/// The trusted certificates for one origin.
struct Trust {
  QList<QSslCertificate> authorities;  // empty: those of the system
  /// SHA-256 of the robot's own certificate (32 bytes). If set, only this certificate is accepted, regardless
  /// of its other errors and of any authority.
  QByteArray pinned_sha256;
};

/// Why a certificate was rejected.
struct CertificateFault {
  QString host;             // "10.0.0.7:8443"
  std::vector<Fault> whys;  // never empty; each with its arguments, such as a date or name
  QByteArray sha256, pinned_sha256;
  QString subject, issuer;  // untrusted plain text
  QDateTime from, until;
  /// Whether the user may trust it anyway. Not if it was revoked or there is none.
  bool trustable() const;
};

/// "AB:CD:…", as printed by `openssl x509 -fingerprint -sha256`.
QString fingerprintText(const QByteArray& sha256);
/// The reverse; ignores blanks and colons. Empty if it is not 32 bytes.
QByteArray fingerprintFrom(const QString& text);
/// CertificateUntrusted or CertificateChanged, with its fingerprints.
Fault reasonOf(const CertificateFault& fault);

/// The TLS configuration. A pinned certificate is judged by faultOf() alone, without any authority.
QSslConfiguration configurationFor(const Trust& trust);
/// Judges `errors` of the certificate of `url`: nullopt = continue and ignore exactly these.
std::optional<CertificateFault> faultOf(const Trust& trust, const QSslCertificate& leaf,
                                        const QList<QSslError>& errors, const QUrl& url);

/// The certificates of a PEM file.
tl::expected<QList<QSslCertificate>, Fault> readAuthorities(const QString& file);

}  // namespace mapwright::net
