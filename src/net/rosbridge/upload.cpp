#include "net/rosbridge/upload.h"

#include <algorithm>

#include <QJsonDocument>
#include <QJsonObject>

namespace mapwright::net::rosbridge {
namespace {

/// {"op":"call_service","id":…,"service":…,"args":
QByteArray headOf(const QString& id, const std::string& service) {
  const QJsonObject request{{QStringLiteral("op"), QStringLiteral("call_service")},
                            {QStringLiteral("id"), id},
                            {QStringLiteral("service"), QString::fromStdString(service)}};
  QByteArray text = QJsonDocument(request).toJson(QJsonDocument::Compact);
  text.chop(1);
  return text + ",\"args\":";
}

bool isWithinCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

}  // namespace

Upload::Upload(const QString& id, const std::string& service, std::shared_ptr<ArgsSource> args,
               qint64 most_whole_bytes, qint64 fragment_bytes)
    : id_(id), args_(std::move(args)), held_(headOf(id, service)), args_left_(args_->bytes()) {
  bytes_ = held_.size() + args_left_ + 1;
  piece_ = bytes_ <= most_whole_bytes ? bytes_ : std::max<qint64>(fragment_bytes, 16);
  count_ = (bytes_ + piece_ - 1) / piece_;
}

bool Upload::holdUntil(qint64 end) {
  while (!given_up_ && handed_out_ + held_.size() < end) {
    if (args_left_ > 0) {
      const auto more = args_->next();
      given_up_ = !more || more->isEmpty() || more->size() > args_left_;
      if (given_up_) break;
      args_left_ -= more->size();
      held_ += *more;
    } else {
      given_up_ = std::exchange(closed_, true);
      held_ += '}';
    }
  }
  return !given_up_;
}

std::optional<QString> Upload::next() {
  if (done() || given_up_) return std::nullopt;
  const bool last = number_ + 1 == count_;
  const qint64 end = last ? bytes_ : (number_ + 1) * piece_;
  if (!holdUntil(last ? end : end + 1)) return std::nullopt;
  qsizetype size = end - handed_out_;
  while (!last && size > 0 && isWithinCharacter(held_[size])) --size;
  const QByteArray piece = held_.first(size);
  held_.remove(0, size);
  handed_out_ += size;
  const QString frame = count_ == 1 ? QString::fromUtf8(piece) : framed(piece);
  ++number_;
  if (done()) args_.reset();
  return frame;
}

QString Upload::framed(const QByteArray& piece) const {
  const QJsonObject fragment{{QStringLiteral("op"), QStringLiteral("fragment")},
                             {QStringLiteral("id"), id_},
                             {QStringLiteral("num"), number_},
                             {QStringLiteral("total"), count_},
                             {QStringLiteral("data"), QString::fromUtf8(piece)}};
  return QString::fromUtf8(QJsonDocument(fragment).toJson(QJsonDocument::Compact));
}

}  // namespace mapwright::net::rosbridge
