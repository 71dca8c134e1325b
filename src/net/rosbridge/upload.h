// A call whose arguments are made while they travel, as text frames: whole, or in fragments (rosbridge v2,
// "fragmentation"; its servers join what comes in pieces).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QByteArray>
#include <QString>

namespace mapwright::net::rosbridge {

/// A JSON object as UTF-8 that is never held as a whole. Used on the thread of the client.
class ArgsSource {
 public:
  virtual ~ArgsSource() = default;
  /// All that next() is going to hand out.
  virtual qint64 bytes() const = 0;
  /// What follows, at least a byte, as much as is convenient; not called beyond bytes(). nullopt: it is not
  /// to be sent after all, and no more is asked for.
  virtual std::optional<QByteArray> next() = 0;
};

/// One thread; nothing is sent here.
class Upload {
 public:
  /// What is no longer than `most_whole_bytes` is one frame, else fragments hold `fragment_bytes` of it each.
  Upload(const QString& id, const std::string& service, std::shared_ptr<ArgsSource> args,
         qint64 most_whole_bytes, qint64 fragment_bytes);

  /// The next frame; nullopt when done() or given up.
  std::optional<QString> next();
  bool done() const { return number_ == count_; }
  bool givenUp() const { return given_up_; }
  /// Of the request as one text, without what cutting it adds.
  qint64 bytes() const { return bytes_; }
  qint64 handedOut() const { return handed_out_; }

 private:
  /// Where piece `number` begins: not within a character. What is held reaches that far.
  bool holdUntil(qint64 end);
  QString framed(const QByteArray& piece) const;

  QString id_;
  std::shared_ptr<ArgsSource> args_;
  QByteArray held_;  // made, and not handed out
  qint64 bytes_ = 0, args_left_ = 0, handed_out_ = 0, piece_ = 0;
  qint64 number_ = 0, count_ = 1;
  bool closed_ = false, given_up_ = false;
};

}  // namespace mapwright::net::rosbridge
