#include "net/trust.h"

#include <algorithm>

#include <QCryptographicHash>
#include <QFile>
#include <QStringList>

#include "net/plain_sentences.h"

namespace mapwright::net {
namespace {

using Reason = CertificateFault::Reason;

constexpr qsizetype kSha256Bytes = 32;
constexpr qsizetype kLongestName = 40;
constexpr qint64 kLongestFile = qint64(8) << 20;  // all authorities of a system are a fraction of it

QString day(const QDateTime& time) { return time.toUTC().date().toString(Qt::ISODate); }

/// Names in certificates are anybody's words.
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

QString namesOf(const QSslCertificate& certificate) {
  QStringList names = certificate.subjectAlternativeNames().values();
  if (names.isEmpty()) names = certificate.subjectInfo(QSslCertificate::CommonName);
  return names.isEmpty() ? QStringLiteral("no name") : shortName(names.first());
}

Reason reasonOf(const QSslError& error, const QSslCertificate& leaf) {
  switch (error.error()) {
    case QSslError::CertificateExpired:
      return Reason::Expired;
    case QSslError::CertificateNotYetValid:
      return Reason::NotYetValid;
    case QSslError::HostNameMismatch:
      return Reason::OtherName;
    case QSslError::CertificateRevoked:
    case QSslError::CertificateBlacklisted:
      return Reason::Revoked;
    case QSslError::SelfSignedCertificate:
      return Reason::SelfSigned;
    case QSslError::SelfSignedCertificateInChain:
    case QSslError::UnableToGetIssuerCertificate:
    case QSslError::UnableToGetLocalIssuerCertificate:
    case QSslError::UnableToVerifyFirstCertificate:
    case QSslError::CertificateUntrusted:
      return leaf.isSelfSigned() ? Reason::SelfSigned : Reason::UnknownAuthority;
    default:
      return Reason::Other;
  }
}

QString words(Reason reason, const QSslCertificate& leaf, const QSslError& error) {
  switch (reason) {
    case Reason::SelfSigned:
      return QStringLiteral("it is self-signed");
    case Reason::UnknownAuthority: {
      const QString issuer = issuerOf(leaf);
      return issuer.isEmpty() ? QStringLiteral("it is issued by an authority that is not known here")
                              : QStringLiteral("it is issued by %1, which is not known here").arg(issuer);
    }
    case Reason::Expired:
      return error.certificate() == leaf ? QStringLiteral("it has expired on %1").arg(day(leaf.expiryDate()))
                                         : QStringLiteral("its authority has expired on %1")
                                               .arg(day(error.certificate().expiryDate()));
    case Reason::NotYetValid:
      return QStringLiteral("it is valid from %1 on only, by the clock of this computer")
          .arg(day(leaf.effectiveDate()));
    case Reason::OtherName:
      return QStringLiteral("it is issued for another name (%1)").arg(namesOf(leaf));
    case Reason::Revoked:
      return QStringLiteral("it was withdrawn");
    case Reason::Changed:
      return QStringLiteral("it is not the one that was trusted");
    case Reason::Other:
      break;
  }
  return plainText(error.errorString());
}

}  // namespace

bool CertificateFault::trustable() const { return !sha256.isEmpty() && !reasons.contains(Reason::Revoked); }

QString fingerprintText(const QByteArray& sha256) { return QString::fromLatin1(sha256.toHex(':').toUpper()); }

QByteArray fingerprintFrom(const QString& text) {
  const QByteArray bytes = QByteArray::fromHex(text.toLatin1());
  return bytes.size() == kSha256Bytes ? bytes : QByteArray();
}

QString sentenceOf(const CertificateFault& fault) {
  if (fault.reasons.contains(Reason::Changed)) {
    return QStringLiteral("the certificate of %1 has changed. Trusted (SHA-256): %2. Now: %3")
        .arg(fault.host, fingerprintText(fault.pinned_sha256), fingerprintText(fault.sha256));
  }
  return QStringLiteral("the certificate of %1 is not trusted: %2. Its SHA-256 fingerprint: %3")
      .arg(fault.host, fault.why, fingerprintText(fault.sha256));
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
  QStringList whys;
  const auto add = [&](Reason reason, const QString& why) {
    if (fault.reasons.contains(reason)) return;
    fault.reasons << reason;
    whys << why;
  };
  const bool pinned = !trust.pinned_sha256.isEmpty();
  if (pinned && fault.sha256 != trust.pinned_sha256) {
    add(Reason::Changed, words(Reason::Changed, leaf, {}));
  }
  for (const QSslError& error : errors) {
    const Reason reason = reasonOf(error, leaf);
    // Of the pinned certificate itself nothing counts any more, except that it was withdrawn.
    if (!pinned || reason == Reason::Revoked) add(reason, words(reason, leaf, error));
  }
  if (fault.reasons.isEmpty()) return std::nullopt;
  fault.why = whys.join(QStringLiteral("; "));
  return fault;
}

tl::expected<QList<QSslCertificate>, QString> readAuthorities(const QString& file) {
  QFile source(file);
  if (!source.open(QIODevice::ReadOnly)) {
    return tl::make_unexpected(
        QStringLiteral("The certificate file %1 cannot be read: %2.").arg(file, source.errorString()));
  }
  const QList<QSslCertificate> certificates = QSslCertificate::fromData(source.read(kLongestFile), QSsl::Pem);
  if (certificates.isEmpty() ||
      std::any_of(certificates.begin(), certificates.end(), [](const auto& one) { return one.isNull(); })) {
    return tl::make_unexpected(
        QStringLiteral(
            "The certificate file %1 holds no certificate in PEM form (-----BEGIN CERTIFICATE-----).")
            .arg(file));
  }
  return certificates;
}

}  // namespace mapwright::net
