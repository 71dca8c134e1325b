#include "sentences/http_status.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(HttpStatus)
};

QString nameOf(int status) {
  switch (status) {
    case 304:
      return Words::tr("not modified");
    case 400:
      return Words::tr("bad request");
    case 401:
      return Words::tr("not authorised");
    case 403:
      return Words::tr("forbidden");
    case 404:
      return Words::tr("not found");
    case 405:
      return Words::tr("method not allowed");
    case 408:
      return Words::tr("request timeout");
    case 409:
      return Words::tr("conflict");
    case 410:
      return Words::tr("gone");
    case 413:
      return Words::tr("too large");
    case 415:
      return Words::tr("unsupported media type");
    case 422:
      return Words::tr("cannot be processed");
    case 426:
      return Words::tr("upgrade required");
    case 429:
      return Words::tr("too many requests");
    case 500:
      return Words::tr("internal error");
    case 501:
      return Words::tr("not implemented");
    case 502:
      return Words::tr("bad gateway");
    case 503:
      return Words::tr("unavailable");
    case 504:
      return Words::tr("gateway timeout");
    default:
      return {};
  }
}

}  // namespace

QString statusWords(int status) {
  const QString name = nameOf(status);
  return name.isEmpty() ? QString::number(status) : QStringLiteral("%1 (%2)").arg(status).arg(name);
}

}  // namespace mapwright::sentences
