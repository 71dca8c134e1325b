// An HTTP request with its data, and its answer, independent of sockets.
#pragma once

#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/fault_plan.h"
#include "simulator/value.h"

namespace mapwright::simulator {

/// A number from a text that must hold nothing else.
template <typename Number>
std::optional<Number> numberFrom(std::string_view text) {
  Number number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

struct HttpQuestion {
  std::string_view method;
  std::string_view target;  // path and query, as sent
  std::string_view secret;
  std::string_view if_none_match;
  std::string_view body;
  std::string_view content_type;
  std::string_view range = {};
  std::string_view if_range = {};
};

struct HttpAnswer {
  int status = 200;
  std::string content_type = "application/json";
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::shared_ptr<const std::string> body = {};
  int delay_ms = 0;
  bool drop = false;      // close without an answer
  bool truncate = false;  // half the body, then close
};

HttpAnswer jsonAnswer(int status, std::string body);
HttpAnswer valueAnswer(int status, const Value& value);
/// {"detail":"..."}: the error format of the Autoxing robot.
HttpAnswer errorAnswer(int status, std::string_view sentence);
/// A path on the host name that the robot uses for itself: these robots put it into their answers, whatever
/// address the client used.
Value ownUrl(std::string_view path);
/// Without a body: 204, 304.
HttpAnswer emptyAnswer(int status);
/// The bytes, or those from where the question wants them (a Range to the end, unless If-Range names another
/// tag).
HttpAnswer bytesFrom(const HttpQuestion& question, std::string bytes, std::string_view tag = {});
/// What comes before the separator; `rest` goes on behind it, and is empty if there is none.
std::string_view partOf(std::string_view& rest, char separator);
/// The path of a target, without its query.
std::string_view pathOf(std::string_view target);
/// The value of `key` in the target's query; empty when absent.
std::string_view queryValue(std::string_view target, std::string_view key);
/// A letter, a digit, - or _.
bool isWordCharacter(char c);
/// Decodes %XX.
std::string percentDecoded(std::string_view text);
/// Encodes everything but letters, digits and -._~ as %XX.
std::string percentEncoded(const std::string& text);
/// Weak comparison of an If-None-Match list with our opaque tag (with its quotes, if it has any), as required
/// by HTTP.
bool matchesTag(std::string_view if_none_match, std::string_view tag);

/// The data of a request: the members of a JSON object, or the parts of a form.
class RequestFields {
 public:
  /// nullopt if the body is neither a JSON object nor, by its content type, a form.
  static std::optional<RequestFields> read(std::string_view content_type, std::string_view body);

  /// Present and not null.
  bool has(std::string_view key) const { return !values_[key].isNull(); }
  std::optional<std::string> text(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;  // finite
  std::optional<std::int64_t> integer(std::string_view key) const;
  /// `otherwise` if it is absent.
  std::optional<bool> flag(std::string_view key, std::optional<bool> otherwise = {}) const;
  std::optional<std::vector<double>> numbers(std::string_view key) const;  // only for a list of numbers

 private:
  static std::optional<RequestFields> readForm(std::string_view boundary, std::string_view body);

  Value values_;
  bool is_form_ = false;  // where numbers are texts
};

/// Answers the requests on a port.
class Answerer {
 public:
  explicit Answerer(FaultPlan& faults) : faults_(faults) {}
  virtual ~Answerer() = default;
  /// As the faults leave it. Safe from any thread.
  HttpAnswer answer(const HttpQuestion& question);
  /// Whether the answer may take milliseconds: then a worker makes it.
  virtual bool isSlow(std::string_view path) const = 0;
  /// Whether a client with this Secret header may use the WebSocket.
  virtual bool opensTopics(std::string_view secret) const = 0;

 protected:
  Faults faults() const { return faults_.faults(); }

 private:
  /// What kinds of Requests it is.
  virtual unsigned kindsOf(const HttpQuestion& question) const = 0;
  virtual HttpAnswer answered(const HttpQuestion& question, const Verdict& verdict) = 0;
  virtual HttpAnswer refused(const HttpQuestion& question, const Verdict& verdict) const = 0;
  /// The answer to a write that is not carried out, as if it was.
  virtual HttpAnswer ignored(const HttpQuestion& question) = 0;

  FaultPlan& faults_;
};

}  // namespace mapwright::simulator
