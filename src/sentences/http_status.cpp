#include "sentences/http_status.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

class HttpStatusText {
  Q_DECLARE_TR_FUNCTIONS(HttpStatus)
};

QString nameOf(int status) {
  switch (status) {
    case 304:
      return HttpStatusText::tr("not modified");
    case 400:
      return HttpStatusText::tr("bad request");
    case 401:
      return HttpStatusText::tr("not authorised");
    case 403:
      return HttpStatusText::tr("forbidden");
    case 404:
      return HttpStatusText::tr("not found");
    case 405:
      return HttpStatusText::tr("method not allowed");
    case 408:
      return HttpStatusText::tr("request timeout");
    case 409:
      return HttpStatusText::tr("conflict");
    case 410:
      return HttpStatusText::tr("gone");
    case 413:
      return HttpStatusText::tr("too large");
    case 415:
      return HttpStatusText::tr("unsupported media type");
    case 422:
      return HttpStatusText::tr("cannot be processed");
    case 426:
      return HttpStatusText::tr("upgrade required");
    case 429:
      return HttpStatusText::tr("too many requests");
    case 500:
      return HttpStatusText::tr("internal error");
    case 501:
      return HttpStatusText::tr("not implemented");
    case 502:
      return HttpStatusText::tr("bad gateway");
    case 503:
      return HttpStatusText::tr("unavailable");
    case 504:
      return HttpStatusText::tr("gateway timeout");
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
