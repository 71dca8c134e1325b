// The meaning of a Cache-Control header for a private cache. Source: RFC 9111, section 5.2; RFC 8246
// (immutable).
#pragma once

#include <optional>

#include <QByteArray>

namespace mapwright::net {

struct CacheControl {
  bool no_store = false;
  bool no_cache = false;
  bool immutable = false;
  std::optional<qint64> max_age_s;  // 0 if it cannot be parsed
};

CacheControl parseCacheControl(const QByteArray& header);

}  // namespace mapwright::net
