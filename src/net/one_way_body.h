// The body of a request that must never be sent twice.
#pragma once

#include <algorithm>
#include <utility>

#include <QByteArray>
#include <QIODevice>

namespace mapwright::net {

/// A body that can be read once and cannot be rewound.
class OneWayBody : public QIODevice {
 public:
  explicit OneWayBody(QByteArray bytes) : bytes_(std::move(bytes)) { open(QIODevice::ReadOnly); }
  /// Whether any of it was read: the server may have received all of it.
  bool begun() const { return begun_; }
  bool isSequential() const override { return true; }
  bool seek(qint64) override { return false; }
  bool atEnd() const override { return read_ >= bytes_.size() && QIODevice::atEnd(); }
  qint64 bytesAvailable() const override { return bytes_.size() - read_ + QIODevice::bytesAvailable(); }

 protected:
  qint64 readData(char* to, qint64 most) override {
    begun_ = true;
    const qint64 count = std::min<qint64>(most, bytes_.size() - read_);
    if (count <= 0) return -1;
    std::copy_n(bytes_.constData() + read_, count, to);
    read_ += count;
    return count;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  QByteArray bytes_;
  qint64 read_ = 0;
  bool begun_ = false;
};

}  // namespace mapwright::net
