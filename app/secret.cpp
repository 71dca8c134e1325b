#include "app/secret.h"

#include <QFile>

namespace mapwright::app {

tl::expected<QByteArray, QString> readSecret(const QString& file) {
  QByteArray secret;
  if (!file.isEmpty()) {
    QFile source(file);
    if (!source.open(QIODevice::ReadOnly)) {
      return tl::make_unexpected(
          QStringLiteral("The secret file %1 cannot be read: %2.").arg(file, source.errorString()));
    }
    secret = source.read(4097).trimmed();
  } else {
    secret = qgetenv("MAPWRIGHT_SECRET").trimmed();
  }
  if (secret.size() > 4096 || secret.contains('\n') || secret.contains('\r') || secret.contains('\0')) {
    return tl::make_unexpected(QStringLiteral("The secret must be one line of at most 4096 bytes."));
  }
  return secret;
}

}  // namespace mapwright::app
