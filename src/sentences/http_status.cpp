#include "sentences/http_status.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

struct StatusName {
  int status;
  const char* name;
};

constexpr StatusName kNames[] = {
    {304, QT_TRANSLATE_NOOP("HttpStatus", "not modified")},
    {400, QT_TRANSLATE_NOOP("HttpStatus", "bad request")},
    {401, QT_TRANSLATE_NOOP("HttpStatus", "not authorised")},
    {403, QT_TRANSLATE_NOOP("HttpStatus", "forbidden")},
    {404, QT_TRANSLATE_NOOP("HttpStatus", "not found")},
    {405, QT_TRANSLATE_NOOP("HttpStatus", "method not allowed")},
    {408, QT_TRANSLATE_NOOP("HttpStatus", "request timeout")},
    {409, QT_TRANSLATE_NOOP("HttpStatus", "conflict")},
    {410, QT_TRANSLATE_NOOP("HttpStatus", "gone")},
    {413, QT_TRANSLATE_NOOP("HttpStatus", "too large")},
    {415, QT_TRANSLATE_NOOP("HttpStatus", "unsupported media type")},
    {422, QT_TRANSLATE_NOOP("HttpStatus", "cannot be processed")},
    {426, QT_TRANSLATE_NOOP("HttpStatus", "upgrade required")},
    {429, QT_TRANSLATE_NOOP("HttpStatus", "too many requests")},
    {500, QT_TRANSLATE_NOOP("HttpStatus", "internal error")},
    {501, QT_TRANSLATE_NOOP("HttpStatus", "not implemented")},
    {502, QT_TRANSLATE_NOOP("HttpStatus", "bad gateway")},
    {503, QT_TRANSLATE_NOOP("HttpStatus", "unavailable")},
    {504, QT_TRANSLATE_NOOP("HttpStatus", "gateway timeout")},
};

}  // namespace

QString statusWords(int status) {
  for (const StatusName& known : kNames) {
    if (known.status == status)
      return QCoreApplication::translate("HttpStatus", "%1 (%2)")
          .arg(status)
          .arg(QCoreApplication::translate("HttpStatus", known.name));
  }
  return QString::number(status);
}

}  // namespace mapwright::sentences
