// An HTTP request and its answer, independent of sockets.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/value.h"

namespace mapwright::simulator {

struct HttpQuestion {
  std::string_view method;
  std::string_view target;  // path and query, as sent
  std::string_view secret;
  std::string_view if_none_match;
  std::string_view body;
  std::string_view content_type;
  std::string_view range = {};
};

struct HttpAnswer {
  int status = 200;
  std::string content_type = "application/json";
  std::vector<std::pair<std::string, std::string>> headers;
  std::shared_ptr<const std::string> body;
  int delay_ms = 0;
  bool drop = false;      // close without an answer
  bool truncate = false;  // half the body, then close
};

HttpAnswer jsonAnswer(int status, std::string body);
HttpAnswer valueAnswer(int status, const Value& value);
/// {"detail":"..."}: the error format of the Autoxing robot.
HttpAnswer errorAnswer(int status, std::string_view sentence);
HttpAnswer notFound();
/// 204 without a body.
HttpAnswer noContent();
/// 405 with Allow if the method is not in `allowed`, such as "GET, POST". HEAD counts as GET.
std::optional<HttpAnswer> refusedMethod(const HttpQuestion& question, std::string_view allowed);

/// The path of a target, without its query.
std::string_view pathOf(std::string_view target);
/// The value of `key` in the target's query; empty when absent.
std::string_view queryValue(std::string_view target, std::string_view key);
/// Decodes %XX; nullopt if it is invalid.
std::optional<std::string> percentDecoded(std::string_view text);
/// Encodes everything but letters, digits and -._~ as %XX.
std::string percentEncoded(std::string_view text);
/// Weak comparison of an If-None-Match list with our opaque tag (with its quotes, if it has any), as required
/// by HTTP.
bool matchesTag(std::string_view if_none_match, std::string_view tag);

/// Answers the requests on a port.
class Answerer {
 public:
  virtual ~Answerer() = default;
  /// Safe from any thread.
  virtual HttpAnswer answer(const HttpQuestion& question) = 0;
  /// Whether the answer may take milliseconds: then a worker makes it.
  virtual bool isSlow(std::string_view path) const = 0;
  /// Whether a client with this Secret header may use the WebSocket.
  virtual bool opensTopics(std::string_view secret) const = 0;
};

}  // namespace mapwright::simulator
