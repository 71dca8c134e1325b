#include "net/cache_control.h"

#include <algorithm>

#include <QList>

namespace mapwright::net {

namespace {

constexpr qint64 kLongestAge = qint64(1) << 31;  // RFC 9111: longer ages may be treated as this one

qint64 parseAge(QByteArray text) {
  text = text.trimmed();
  if (text.size() >= 2 && text.startsWith('"') && text.endsWith('"')) {
    text = text.mid(1, text.size() - 2);
  }
  const bool digits =
      !text.isEmpty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) {
    return 0;
  }
  bool fits = false;
  const qint64 age = text.toLongLong(&fits);
  return fits ? std::min(age, kLongestAge) : kLongestAge;
}

}  // namespace

CacheControl parseCacheControl(const QByteArray& header) {
  CacheControl control;
  for (const QByteArray& directive : header.split(',')) {
    const auto equals = directive.indexOf('=');
    const QByteArray name = (equals < 0 ? directive : directive.left(equals)).trimmed().toLower();
    if (name == "no-store") {
      control.no_store = true;
    } else if (name == "no-cache") {
      control.no_cache = true;
    } else if (name == "immutable") {
      control.immutable = true;
    } else if (name == "max-age") {
      control.max_age_s = equals < 0 ? 0 : parseAge(directive.mid(equals + 1));
    }
  }
  return control;
}

}  // namespace mapwright::net
