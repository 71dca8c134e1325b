#include "net/cache_writer.h"

#include <utility>

namespace mapwright::net {

namespace {

qint64 bytesOf(const CacheWriter::Errand& errand) { return errand.record ? fileBytes(*errand.record) : 0; }

}  // namespace

CacheWriter::CacheWriter(CacheFolder& folder, std::function<void(const Fault& why)> failed)
    : folder_(folder), failed_(std::move(failed)) {}

CacheWriter::~CacheWriter() {
  if (!thread_) return;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  asked_.notify_one();
  thread_->wait();
}

void CacheWriter::keep(const QByteArray& name, CacheRecord record, qint64 now_ms) {
  ask(name, {std::move(record), now_ms});
}

void CacheWriter::remove(const QByteArray& name) { ask(name, {}); }

void CacheWriter::ask(const QByteArray& name, Errand errand) {
  if (!thread_) {
    thread_.reset(QThread::create([this] { work(); }));
    thread_->setObjectName(QStringLiteral("cache writer"));
    thread_->start();
  }
  const qint64 bytes = bytesOf(errand);
  {
    std::unique_lock lock(mutex_);
    // A removal never waits: it needs no memory, and it is important.
    done_.wait(lock, [&] {
      return bytes == 0 || waiting_bytes_ == 0 || waiting_bytes_ + bytes <= kMostWaitingBytes;
    });
    const auto before = errands_.find(name);
    if (before != errands_.end()) {
      waiting_bytes_ += bytes - bytesOf(*before);
      *before = std::move(errand);
      return;
    }
    waiting_bytes_ += bytes;
    errands_.insert(name, std::move(errand));
    order_.push_back(name);
  }
  asked_.notify_one();
}

std::optional<CacheWriter::Errand> CacheWriter::waiting(const QByteArray& name) const {
  const std::lock_guard lock(mutex_);
  if (const auto found = errands_.constFind(name); found != errands_.constEnd()) return *found;
  return name == name_under_way_ ? under_way_ : std::nullopt;
}

void CacheWriter::flush() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return order_.empty() && !under_way_; });
}

void CacheWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    asked_.wait(lock, [this] { return closing_ || !order_.empty(); });
    if (order_.empty()) return;
    name_under_way_ = std::move(order_.front());
    order_.pop_front();
    under_way_ = errands_.take(name_under_way_);
    lock.unlock();
    const Fault why = under_way_->record
                          ? folder_.keep(name_under_way_, *under_way_->record, under_way_->now_ms)
                          : folder_.remove(name_under_way_);
    if (why.any()) failed_(why);
    lock.lock();
    waiting_bytes_ -= bytesOf(*under_way_);
    under_way_.reset();
    name_under_way_.clear();
    done_.notify_all();
  }
}

}  // namespace mapwright::net
