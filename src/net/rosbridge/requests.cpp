#include "net/rosbridge/requests.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>
#include <simdjson.h>

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

}  // namespace

std::optional<QString> callRequest(const QString& id, const std::string& service, const QByteArray& args) {
  if (service.empty() || !isObject(args))
    return std::nullopt;  // without a service there will never be an answer
  QJsonObject request;
  request[QLatin1String("op")] = QLatin1String("call_service");
  request[QLatin1String("id")] = id;
  request[QLatin1String("service")] = QString::fromStdString(service);
  QString text = written(request);
  text.chop(1);
  // Unchanged: QJsonDocument would turn 2 into 2.0, which servers distinguish.
  return text + QLatin1String(",\"args\":") + QString::fromUtf8(args) + QLatin1Char('}');
}

QString subscribeRequest(const QString& id, const Subscription& wanted) {
  QJsonObject request;
  request[QLatin1String("op")] = QLatin1String("subscribe");
  request[QLatin1String("id")] = id;
  request[QLatin1String("topic")] = QString::fromStdString(wanted.topic);
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
  QJsonObject request;
  request[QLatin1String("op")] = QLatin1String("unsubscribe");
  request[QLatin1String("id")] = id;
  request[QLatin1String("topic")] = QString::fromStdString(topic);
  return written(request);
}

QString authRequest(const Credentials& credentials, const QString& rand, qint64 now_s) {
  const qint64 end_s = now_s + credentials.valid_s;
  QCryptographicHash hash(QCryptographicHash::Sha512);
  hash.addData(credentials.secret);
  for (const QString& part : {credentials.client, credentials.destination, rand, QString::number(now_s),
                              credentials.level, QString::number(end_s)}) {
    hash.addData(part.toUtf8());
  }
  QJsonObject request;
  request[QLatin1String("op")] = QLatin1String("auth");
  request[QLatin1String("mac")] = QString::fromLatin1(hash.result().toHex());
  request[QLatin1String("client")] = credentials.client;
  request[QLatin1String("dest")] = credentials.destination;
  request[QLatin1String("rand")] = rand;
  request[QLatin1String("t")] = now_s;
  request[QLatin1String("level")] = credentials.level;
  request[QLatin1String("end")] = end_s;
  return written(request);
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

}  // namespace mapwright::net::rosbridge
