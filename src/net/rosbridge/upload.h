// A call whose arguments are produced while they are sent, as text frames: in one piece, or in fragments
// (rosbridge v2, "fragmentation").
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QByteArray>
#include <QString>

namespace mapwright::net::rosbridge {

/// A JSON object as UTF-8 that is never in memory as a whole. Used on the client's thread.
class ArgsSource {
 public:
  virtual ~ArgsSource() = default;
  /// The total size of all next().
  virtual qint64 bytes() const = 0;
  /// The next part, at least one byte, of any convenient size; not called beyond bytes(). nullopt: cancel
  /// sending; it is not called again.
  virtual std::optional<QByteArray> next() = 0;
};

/// One thread; does not send by itself.
class Upload {
 public:
  /// Up to `most_whole_bytes` it is one frame, otherwise fragments of `fragment_bytes` each.
  Upload(const QString& id, const std::string& service, std::shared_ptr<ArgsSource> args,
         qint64 most_whole_bytes, qint64 fragment_bytes);

  /// The next frame; nullopt if done() or cancelled.
  std::optional<QString> next();
  bool done() const { return number_ == count_; }
  bool givenUp() const { return given_up_; }
  /// Of the request as one text, without the overhead of fragments.
  qint64 bytes() const { return bytes_; }
  qint64 handedOut() const { return handed_out_; }

 private:
  /// Where fragment `number` begins: never inside a character. Buffers data up to there.
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
