#include "net/trust.h"

#include <algorithm>

#include <QCryptographicHash>
#include <QFile>
#include <QStringList>

#include "net/plain_sentences.h"

namespace mapwright::net {
namespace {

using Kind = CertificateFault::Reason;

constexpr qsizetype kSha256Bytes = 32;
constexpr qsizetype kLongestName = 40;
constexpr qint64 kLongestFile = qint64(8) << 20;  // all authorities of a system are much smaller

QString day(const QDateTime& time) { return time.toUTC().date().toString(Qt::ISODate); }

/// Names in certificates are untrusted.
QString shortName(const QString& name) {
  const QString plain = plainText(name);
  return plain.size() > kLongestName ? plain.left(kLongestName - 1) + QChar(u'\u2026') : plain;
}

QString commonName(const QStringList& names, const QStringList& organizations) {
  const QString name = names.value(0).isEmpty() ? organizations.value(0) : names.value(0);
  return shortName(name);
}

QString subjectOf(const QSslCertificate& certificate) {
  return commonName(certificate.subjectInfo(QSslCertificate::CommonName),
                    certificate.subjectInfo(QSslCertificate::Organization));
}

QString issuerOf(const QSslCertificate& certificate) {
  return commonName(certificate.issuerInfo(QSslCertificate::CommonName),
                    certificate.issuerInfo(QSslCertificate::Organization));
}

/// The first name that it is issued for; empty: none.
QString nameOf(const QSslCertificate& certificate) {
  QStringList names = certificate.subjectAlternativeNames().values();
  if (names.isEmpty()) names = certificate.subjectInfo(QSslCertificate::CommonName);
  return names.isEmpty() ? QString() : shortName(names.first());
}

Kind kindOf(const QSslError& error, const QSslCertificate& leaf) {
  switch (error.error()) {
    case QSslError::CertificateExpired:
      return Kind::Expired;
    case QSslError::CertificateNotYetValid:
      return Kind::NotYetValid;
    case QSslError::HostNameMismatch:
      return Kind::OtherName;
    case QSslError::CertificateRevoked:
    case QSslError::CertificateBlacklisted:
      return Kind::Revoked;
    case QSslError::SelfSignedCertificate:
      return Kind::SelfSigned;
    case QSslError::SelfSignedCertificateInChain:
    case QSslError::UnableToGetIssuerCertificate:
    case QSslError::UnableToGetLocalIssuerCertificate:
    case QSslError::UnableToVerifyFirstCertificate:
    case QSslError::CertificateUntrusted:
      return leaf.isSelfSigned() ? Kind::SelfSigned : Kind::UnknownAuthority;
    default:
      return Kind::Other;
  }
}

Fault detailed(Kind kind, const QSslCertificate& leaf, const QSslError& error) {
  switch (kind) {
    case Kind::SelfSigned:
      return fault::SelfSigned;
    case Kind::UnknownAuthority: {
      const QString issuer = issuerOf(leaf);
      if (issuer.isEmpty()) return fault::AuthorityUnnamed;
      return faultOf(fault::AuthorityUnknown, {issuer});
    }
    case Kind::Expired:
      if (error.certificate() == leaf) return faultOf(fault::CertificateExpired, {day(leaf.expiryDate())});
      return faultOf(fault::AuthorityExpired, {day(error.certificate().expiryDate())});
    case Kind::NotYetValid:
      return faultOf(fault::CertificateNotYetValid, {day(leaf.effectiveDate())});
    case Kind::OtherName: {
      const QString name = nameOf(leaf);
      if (name.isEmpty()) return fault::CertificateWithoutName;
      return faultOf(fault::CertificateOfOtherName, {name});
    }
    case Kind::Revoked:
      return fault::CertificateWithdrawn;
    case Kind::Changed:
      return fault::CertificateIsAnother;
    case Kind::Other:
      break;
  }
  return faultOf(fault::Said, {plainText(error.errorString())});
}

}  // namespace

bool CertificateFault::trustable() const { return !sha256.isEmpty() && !reasons.contains(Kind::Revoked); }

QString fingerprintText(const QByteArray& sha256) { return QString::fromLatin1(sha256.toHex(':').toUpper()); }

QByteArray fingerprintFrom(const QString& text) {
  const QByteArray bytes = QByteArray::fromHex(text.toLatin1());
  return bytes.size() == kSha256Bytes ? bytes : QByteArray();
}

Fault reasonOf(const CertificateFault& fault) {
  if (fault.reasons.contains(Kind::Changed)) {
    return faultOf(fault::CertificateChanged,
                   {fault.host, fingerprintText(fault.pinned_sha256), fingerprintText(fault.sha256)});
  }
  Fault reason = faultOf(fault::CertificateUntrusted, {fault.host, fingerprintText(fault.sha256)});
  reason.because = fault.whys;
  return reason;
}

QSslConfiguration configurationFor(const Trust& trust) {
  QSslConfiguration configuration = QSslConfiguration::defaultConfiguration();
  if (!trust.pinned_sha256.isEmpty()) {
    configuration.setCaCertificates({});
  } else if (!trust.authorities.isEmpty()) {
    configuration.setCaCertificates(trust.authorities);
  }
  return configuration;
}

std::optional<CertificateFault> faultOf(const Trust& trust, const QSslCertificate& leaf,
                                        const QList<QSslError>& errors, const QUrl& url) {
  CertificateFault fault;
  fault.host = hostAndPort(url);
  fault.sha256 = leaf.isNull() ? QByteArray() : leaf.digest(QCryptographicHash::Sha256);
  fault.pinned_sha256 = trust.pinned_sha256;
  fault.subject = subjectOf(leaf);
  fault.issuer = issuerOf(leaf);
  fault.from = leaf.effectiveDate();
  fault.until = leaf.expiryDate();
  const auto add = [&](Kind kind, const QSslError& error) {
    if (fault.reasons.contains(kind)) return;
    fault.reasons << kind;
    fault.whys.push_back(detailed(kind, leaf, error));
  };
  const bool pinned = !trust.pinned_sha256.isEmpty();
  if (pinned && fault.sha256 != trust.pinned_sha256) add(Kind::Changed, {});
  for (const QSslError& error : errors) {
    const Kind kind = kindOf(error, leaf);
    // For the pinned certificate itself no error counts, except revocation.
    if (!pinned || kind == Kind::Revoked) add(kind, error);
  }
  if (fault.reasons.isEmpty()) return std::nullopt;
  return fault;
}

tl::expected<QList<QSslCertificate>, Fault> readAuthorities(const QString& file) {
  QFile source(file);
  if (!source.open(QIODevice::ReadOnly)) {
    return tl::make_unexpected(
        faultOf(fault::AuthoritiesNotRead, {plainText(file), plainText(source.errorString())}));
  }
  const QList<QSslCertificate> certificates = QSslCertificate::fromData(source.read(kLongestFile), QSsl::Pem);
  if (certificates.isEmpty() ||
      std::any_of(certificates.begin(), certificates.end(), [](const auto& one) { return one.isNull(); })) {
    return tl::make_unexpected(faultOf(fault::NoAuthoritiesInFile, {plainText(file)}));
  }
  return certificates;
}

}  // namespace mapwright::net
