#include "net/rosbridge/requests.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>
#include <simdjson.h>

#include "net/plain_sentences.h"
#include "net/rosbridge/cbor_item.h"

namespace mapwright::net::rosbridge {
namespace {

QString written(const QJsonObject& object) {
  return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

bool isObject(const QByteArray& json) {
  simdjson::dom::parser parser;
  simdjson::dom::element root;
  return !parser.allocate(std::size_t(json.size()), kMaxDepth) &&
         !parser.parse(json.constData(), std::size_t(json.size())).get(root) && root.is_object();
}

/// The content of a Python literal for bytes or text, without quotes.
std::string unescaped(std::string_view literal) {
  std::string out;
  for (std::size_t i = 0; i < literal.size(); ++i) {
    if (literal[i] != '\\' || i + 1 == literal.size()) {
      out += literal[i];
      continue;
    }
    const char c = literal[++i];
    unsigned byte = 0;
    const char* const first = literal.data() + i + 1;
    if (c == 'x' && literal.size() - i > 2 && std::from_chars(first, first + 2, byte, 16).ptr == first + 2) {
      out += char(byte);
      i += 2;
    } else if (c == 'n' || c == 't' || c == 'r') {
      out += c == 'n' ? '\n' : c == 't' ? '\t' : '\r';
    } else if (c == '\\' || c == '\'' || c == '"') {
      out += c;
    } else {
      out += '\\';
      out += c;
    }
  }
  // The bytes may be invalid UTF-8, completely or in part.
  return QString::fromStdString(out).toStdString();
}

/// {"op":"call_service","id":…,"service":…,"args":
QByteArray headOf(const QString& id, const std::string& service) {
  QByteArray text = QJsonDocument(QJsonObject{{QStringLiteral("op"), QStringLiteral("call_service")},
                                              {QStringLiteral("id"), id},
                                              {QStringLiteral("service"), QString::fromStdString(service)}})
                        .toJson(QJsonDocument::Compact);
  text.chop(1);
  return text + ",\"args\":";
}

bool isWithinCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Text of a server for display: bounded and plain.
std::string plainWords(const std::string& words) {
  return plainText(QString::fromStdString(words)).toStdString();
}

}  // namespace

std::optional<QString> callRequest(const QString& id, const std::string& service, const QByteArray& args) {
  if (service.empty() || !isObject(args))
    return std::nullopt;  // without a service there will never be an answer
  // Unchanged: QJsonDocument would turn 2 into 2.0, which servers distinguish.
  return QString::fromUtf8(headOf(id, service) + args + '}');
}

QString subscribeRequest(const QString& id, const Subscription& wanted) {
  QJsonObject request{{QStringLiteral("op"), QStringLiteral("subscribe")},
                      {QStringLiteral("id"), id},
                      {QStringLiteral("topic"), QString::fromStdString(wanted.topic)}};
  if (!wanted.type.empty()) request[QLatin1String("type")] = QString::fromStdString(wanted.type);
  if (wanted.throttle_ms > 0) {
    request[QLatin1String("throttle_rate")] = wanted.throttle_ms;
    request[QLatin1String("queue_length")] = 1;  // without it the last one is dropped
  }
  if (wanted.compression != Subscription::Compression::None) {
    request[QLatin1String("compression")] =
        QLatin1String(wanted.compression == Subscription::Compression::Cbor ? "cbor" : "png");
  }
  return written(request);
}

QString unsubscribeRequest(const QString& id, const std::string& topic) {
  return written({{QStringLiteral("op"), QStringLiteral("unsubscribe")},
                  {QStringLiteral("id"), id},
                  {QStringLiteral("topic"), QString::fromStdString(topic)}});
}

QString authRequest(const Credentials& credentials, const QString& rand, qint64 now_s) {
  const qint64 end_s = now_s + credentials.valid_s;
  QCryptographicHash hash(QCryptographicHash::Sha512);
  hash.addData(credentials.secret);
  for (const QString& part : {credentials.client, credentials.destination, rand, QString::number(now_s),
                              credentials.level, QString::number(end_s)}) {
    hash.addData(part.toUtf8());
  }
  return written({{QStringLiteral("op"), QStringLiteral("auth")},
                  {QStringLiteral("mac"), QString::fromLatin1(hash.result().toHex())},
                  {QStringLiteral("client"), credentials.client},
                  {QStringLiteral("dest"), credentials.destination},
                  {QStringLiteral("rand"), rand},
                  {QStringLiteral("t"), now_s},
                  {QStringLiteral("level"), credentials.level},
                  {QStringLiteral("end"), end_s}});
}

std::string innerWords(const std::string& words) {
  constexpr std::string_view kBefore = "responded with an error: ";
  const std::size_t at = words.find(kBefore);
  if (!words.starts_with("service [") || at == std::string::npos) return words;
  std::string_view inner = std::string_view(words).substr(at + kBefore.size());
  while (!inner.empty() && (inner.back() == ' ' || inner.back() == '\n')) inner.remove_suffix(1);
  if (inner.starts_with('b')) inner.remove_prefix(1);
  const bool quoted =
      inner.size() >= 2 && (inner.front() == '\'' || inner.front() == '"') && inner.back() == inner.front();
  if (!quoted) return std::string(std::string_view(words).substr(at + kBefore.size()));
  return unescaped(inner.substr(1, inner.size() - 2));
}

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
  return written({{QStringLiteral("op"), QStringLiteral("fragment")},
                  {QStringLiteral("id"), id_},
                  {QStringLiteral("num"), number_},
                  {QStringLiteral("total"), count_},
                  {QStringLiteral("data"), QString::fromUtf8(piece)}});
}

std::optional<QString> idIn(const Field& id) {
  if (id.isText()) return QString::fromStdString(id.text());
  const std::optional<std::int64_t> whole = id.integer();
  return whole ? std::optional(QString::number(*whole)) : std::nullopt;
}

CallAnswer readAnswer(const std::shared_ptr<const Frame>& frame) {
  using Kind = CallAnswer::Kind;
  constexpr qsizetype kShown = 300;
  CallAnswer answer;
  answer.frame = frame;
  answer.sent = true;
  const Field root = frame->root();
  const Field values = root["values"];
  const Field result = root["result"];
  // Old servers omit the result of successful calls.
  const std::optional<bool> worked = result              ? result.flag()
                                     : values.isObject() ? std::optional(true)
                                                         : std::nullopt;
  if (worked == false) {
    answer.kind = Kind::Refused;
    answer.words = values.isText() ? plainWords(innerWords(values.text()))
                   : values        ? plainWords(values.toJson(kShown).toStdString())
                                   : std::string();
  } else if (worked == true && (values.isObject() || values.isNull() || values.isText())) {
    answer.kind = Kind::Answered;
    answer.values = values;
  } else {
    answer.kind = Kind::Malformed;
    answer.words = plainWords(root.toJson(kShown).toStdString());
  }
  return answer;
}

}  // namespace mapwright::net::rosbridge
