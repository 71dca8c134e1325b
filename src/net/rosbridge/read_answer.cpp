#include "net/rosbridge/read_answer.h"

#include "net/plain_sentences.h"
#include "net/rosbridge/requests.h"

namespace mapwright::net::rosbridge {
namespace {

using Kind = CallAnswer::Kind;

/// Text of a server for display: bounded and plain.
std::string plainWords(const std::string& words) {
  return plainText(QString::fromStdString(words)).toStdString();
}

}  // namespace

std::optional<QString> idIn(const Field& id) {
  if (id.isText()) return QString::fromStdString(id.text());
  const std::optional<std::int64_t> whole = id.integer();
  return whole ? std::optional(QString::number(*whole)) : std::nullopt;
}

CallAnswer readAnswer(const std::shared_ptr<const Frame>& frame) {
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
