#include "net/http_cache.h"

#include <utility>

#include <QCryptographicHash>

#include "net/cache_control.h"
#include "net/log.h"

namespace mapwright::net {

namespace {

QByteArray keyOf(const QUrl& url) { return url.toEncoded(QUrl::RemoveFragment | QUrl::RemoveUserInfo); }

QByteArray nameOf(const QUrl& url) {
  return QCryptographicHash::hash(keyOf(url), QCryptographicHash::Sha1).toHex();
}

}  // namespace

HttpCache::HttpCache(QString folder, qint64 budget_bytes, Now now, WriteFile write)
    : now_(std::move(now)),
      folder_(std::move(folder), budget_bytes, std::move(write)),
      writer_(folder_, [this](const Fault& why) { noteFailure(why); }) {}

HttpCache::~HttpCache() = default;

std::optional<CacheRecord> HttpCache::read(const QByteArray& name, const QUrl& url) {
  if (auto errand = writer_.waiting(name)) return std::move(errand->record);
  auto found = folder_.read(name, keyOf(url), now_().toMSecsSinceEpoch());
  if (found.broken) {
    qCInfo(lcCache, "%s: what was kept is broken", qUtf8Printable(urlForLog(url)));
    writer_.remove(name);
  }
  return std::move(found.record);
}

std::optional<CachedAnswer> HttpCache::find(const QUrl& url) {
  const auto record = read(nameOf(url), url);
  if (!record) {
    return std::nullopt;
  }
  // An answer from the future means that the clock was set back: its age is unknown.
  const qint64 age_ms = now_().toMSecsSinceEpoch() - record->stored_ms;
  const bool fresh = record->fresh_s == kForever || (age_ms >= 0 && age_ms < record->fresh_s * 1000);
  return CachedAnswer{record->body, record->content_type, record->etag, fresh};
}

void HttpCache::store(const QUrl& url, const QByteArray& body, const QByteArray& content_type,
                      const QByteArray& cache_control, const QByteArray& etag, bool content_addressed) {
  const QByteArray name = nameOf(url);
  const CacheControl control = parseCacheControl(cache_control);
  CacheRecord record{keyOf(url), content_type, etag, now_().toMSecsSinceEpoch(), 0, body};
  if (control.no_cache) {
    record.fresh_s = 0;
  } else if (control.max_age_s) {
    record.fresh_s = *control.max_age_s;
  } else if (control.immutable || (content_addressed && etag.isEmpty())) {
    record.fresh_s = kForever;
  }
  const bool of_use = record.fresh_s != 0 || !etag.isEmpty();
  if (control.no_store || !of_use) {
    qCDebug(lcCache, "%s: not kept, its headers forbid it", qUtf8Printable(urlForLog(url)));
    writer_.remove(name);
    return;
  }
  qCDebug(lcCache, "%s: kept, %lld bytes", qUtf8Printable(urlForLog(url)), (long long)(body.size()));
  keep(name, std::move(record));
}

void HttpCache::refresh(const QUrl& url, const QByteArray& cache_control, const QByteArray& etag) {
  const QByteArray name = nameOf(url);
  auto record = read(name, url);
  if (!record) {
    return;
  }
  const CacheControl control = parseCacheControl(cache_control);
  if (control.no_store) {
    writer_.remove(name);
    return;
  }
  if (control.no_cache) {
    record->fresh_s = 0;
  } else if (control.max_age_s) {
    record->fresh_s = *control.max_age_s;
  } else if (control.immutable) {
    record->fresh_s = kForever;
  }
  if (!etag.isEmpty()) {
    record->etag = etag;
  }
  record->stored_ms = now_().toMSecsSinceEpoch();
  keep(name, std::move(*record));
}

void HttpCache::copy(const QUrl& from, const QUrl& to) {
  auto record = read(nameOf(from), from);
  if (!record) {
    return;
  }
  record->url = keyOf(to);
  keep(nameOf(to), std::move(*record));
}

void HttpCache::remove(const QUrl& url) {
  qCDebug(lcCache, "%s: removed", qUtf8Printable(urlForLog(url)));
  writer_.remove(nameOf(url));
}

void HttpCache::keep(const QByteArray& name, CacheRecord record) {
  if (fileBytes(record) > folder_.budgetBytes()) {
    writer_.remove(name);
    return;
  }
  writer_.keep(name, std::move(record), now_().toMSecsSinceEpoch());
}

void HttpCache::flush() {
  writer_.flush();
  tell();
}

qint64 HttpCache::bytes() {
  flush();
  return folder_.bytes();  // the writer is idle until the next request, which only this thread can make
}

void HttpCache::noteFailure(const Fault& why) {
  qCInfo(lcCache, "%s", inEnglish(why).c_str());
  const std::lock_guard lock(mutex_);
  last_error_ = why;
  if (untold_) return;  // already in progress
  untold_ = why;
  QMetaObject::invokeMethod(
      &here_, [this] { tell(); }, Qt::QueuedConnection);
}

void HttpCache::tell() {
  std::optional<Fault> why;
  {
    const std::lock_guard lock(mutex_);
    why = std::exchange(untold_, std::nullopt);
  }
  if (!why) return;
  if (const Trouble tell = std::exchange(trouble_, nullptr)) tell(*why);
}

Fault HttpCache::lastError() const {
  const std::lock_guard lock(mutex_);
  return last_error_;
}

}  // namespace mapwright::net
