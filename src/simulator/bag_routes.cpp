#include <algorithm>
#include <cmath>

#include "simulator/json_shapes.h"
#include "simulator/request_fields.h"
#include "simulator/routes.h"
#include "simulator/whole_text.h"

namespace mapwright::simulator {
namespace {

constexpr double kLongestRecordingS = 300, kUsualRecordingS = 120;
constexpr std::size_t kLongestSuffix = 64;
constexpr std::size_t kKeptRecordings = 4;

/// The player reports its errors under another name than the rest of the robot.
HttpAnswer playerError(std::string_view sentence) {
  return valueAnswer(400, Value::Object{{"error", sentence}});
}

HttpAnswer noSuchFile() { return errorAnswer(404, "There is no such file."); }

Value fileValue(BagFolder folder, const Bag& bag) {
  const std::size_t bytes = bagBytes(bag).size();
  const char* const place = folder == BagFolder::Bags ? "/bags/" : "/recording/";
  return Value::Object{{"filename", bag.name},
                       {"size", listedSize(bytes)},
                       {"size_bytes", bytes},
                       {"end", listedTime(bag.span.until_s)},
                       {"download_url", ownUrl(place + percentEncoded(bag.name) + "/download")}};
}

/// "90s", "2m".
std::optional<double> secondsFrom(std::string_view duration) {
  if (duration.size() < 2) return std::nullopt;
  const std::optional<int> number = numberFrom<int>(duration.substr(0, duration.size() - 1));
  const double unit_s = duration.back() == 'm' ? 60 : duration.back() == 's' ? 1 : 0;
  if (!number || *number < 1 || unit_s == 0 || *number * unit_s > kLongestRecordingS) return std::nullopt;
  return *number * unit_s;
}

bool isSuffix(std::string_view suffix) {
  return suffix.size() <= kLongestSuffix && std::all_of(suffix.begin(), suffix.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
                  c == '_';
         });
}

}  // namespace

std::optional<HttpAnswer> BagRoutes::answer(const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  for (const auto& [prefix, folder] :
       {std::pair{std::string_view("/bags"), BagFolder::Bags}, {"/recording", BagFolder::Recordings}}) {
    if (!path.starts_with(prefix)) continue;
    const std::string_view rest = path.substr(prefix.size());
    if (rest.empty() || rest == "/") return collection(folder, question);
    if (rest.starts_with('/')) return file(folder, rest.substr(1), question);
  }
  return std::nullopt;
}

HttpAnswer BagRoutes::collection(BagFolder folder, const HttpQuestion& question) {
  const bool takes_orders = folder == BagFolder::Recordings;
  if (auto refused = refusedMethod(question, takes_orders ? "GET, POST, DELETE" : "GET, DELETE"))
    return *refused;
  if (question.method == "POST") return record(question);
  if (question.method == "DELETE") {
    store_.removeAll(folder);
    return noContent();
  }
  Value::List files;
  for (const Bag& bag : store_.list(folder)) files.push_back(fileValue(folder, bag));
  return valueAnswer(200, files);
}

HttpAnswer BagRoutes::record(const HttpQuestion& question) {
  const std::optional<RequestFields> fields = RequestFields::read({}, question.body);
  if (!fields) return errorAnswer(400, "The request is no JSON object.");
  const std::optional<std::string> suffix =
      fields->has("filename_suffix") ? fields->text("filename_suffix") : std::string();
  if (!suffix || !isSuffix(*suffix))
    return errorAnswer(400, "filename_suffix: must be at most 64 letters, digits, - and _.");
  const std::optional<double> duration_s =
      fields->has("duration") ? secondsFrom(fields->text("duration").value_or("")) : kUsualRecordingS;
  if (!duration_s) return errorAnswer(400, "duration: must be such as \"2m\", at most \"5m\".");
  if (fields->has("category") && fields->text("category") != "pos")
    return errorAnswer(400, "category: only \"pos\" is supported.");
  return valueAnswer(
      201, fileValue(BagFolder::Recordings, store_.record(*suffix, *duration_s, fields->has("category"))));
}

HttpAnswer BagRoutes::file(BagFolder folder, std::string_view rest, const HttpQuestion& question) {
  const std::size_t slash = rest.find('/');
  const std::string_view part = slash == std::string_view::npos ? std::string_view() : rest.substr(slash);
  const std::optional<std::string> name = percentDecoded(rest.substr(0, slash));
  const std::optional<Bag> bag = name ? store_.find(folder, *name) : std::nullopt;
  if (part == "/player") {
    if (auto refused = refusedMethod(question, "GET")) return *refused;
    return player(bag, question);
  }
  if (!bag) return noSuchFile();
  if (part == "/download") {
    if (auto refused = refusedMethod(question, "GET")) return *refused;
    return download(bagBytes(*bag), question.range);
  }
  if (!part.empty() && part != "/") return notFound();
  if (auto refused = refusedMethod(question, "GET, DELETE")) return *refused;
  if (question.method == "GET") return valueAnswer(200, fileValue(folder, *bag));
  switch (store_.remove(folder, bag->name)) {
    case BagStore::Removal::Removed:
      return noContent();
    case BagStore::Removal::Recording:
      return errorAnswer(400, "This bag is still being recorded.");
    case BagStore::Removal::Missing:
      break;
  }
  return noSuchFile();
}

HttpAnswer BagRoutes::download(std::string bytes, std::string_view range) const {
  HttpAnswer answer;
  answer.content_type = "application/octet-stream";
  answer.headers = {{"Content-Disposition", "attachment"}};
  constexpr std::string_view kUnit = "bytes=";
  const bool asked = robot_.options.bags.ranges && range.starts_with(kUnit) && range.ends_with('-');
  const auto from = asked
                        ? numberFrom<std::size_t>(range.substr(kUnit.size(), range.size() - kUnit.size() - 1))
                        : std::nullopt;
  if (from) {
    std::string range_of("bytes ");
    if (*from >= bytes.size()) {
      answer.status = 416;
      range_of.append("*");
    } else {
      answer.status = 206;
      range_of.append(std::to_string(*from)).append("-").append(std::to_string(bytes.size() - 1));
    }
    range_of.append("/").append(std::to_string(bytes.size()));
    answer.headers.emplace_back("Content-Range", range_of);
    bytes.erase(0, std::min(*from, bytes.size()));
  }
  answer.body = std::make_shared<const std::string>(std::move(bytes));
  return answer;
}

std::shared_ptr<const BagRecording> BagRoutes::recordingOf(const Bag& bag) {
  const std::lock_guard lock(mutex_);
  for (auto known = recordings_.begin(); known != recordings_.end(); ++known) {
    if (known->first != bag.span) continue;
    recordings_.splice(recordings_.begin(), recordings_, known);
    return recordings_.front().second;
  }
  recordings_.emplace_front(bag.span,
                            std::make_shared<const BagRecording>(robot_.state, robot_.library.atFirst(),
                                                                 robot_.options.seed, bag.span));
  if (recordings_.size() > kKeptRecordings) recordings_.pop_back();
  return recordings_.front().second;
}

HttpAnswer BagRoutes::player(const std::optional<Bag>& bag, const HttpQuestion& question) {
  if (!bag) return playerError("The bag file was not found.");
  if (bag->condition == BagCondition::Corrupt)
    return playerError("The bag file is corrupted: its index is missing.");
  if (bag->condition == BagCondition::Recording) return playerError("The bag file is still being recorded.");
  const std::string_view start = queryValue(question.target, "start_time"),
                         end = queryValue(question.target, "end_time");
  const std::optional<double> from = numberFrom<double>(start), until = numberFrom<double>(end);
  const bool whole = start.empty() && end.empty();
  if (!whole) {
    if (start.empty() || end.empty()) return playerError("start_time and end_time are both required.");
    if (!from || !until || !std::isfinite(*from) || !std::isfinite(*until))
      return playerError("start_time and end_time must be numbers.");
    if (*until < *from) return playerError("end_time lies before start_time.");
  }
  const std::shared_ptr<const BagRecording> recording = recordingOf(*bag);
  Value body = Value::Object{{"total_messages", recording->messages()},
                             {"start_time", recording->startTime()},
                             {"end_time", recording->endTime()}};
  const auto end_of =
      robot_.options.bags.end_exclusive ? BagRecording::End::Exclusive : BagRecording::End::Inclusive;
  if (!whole) body.set("messages", Value::Json{recording->messagesJson(*from, *until, end_of)});
  HttpAnswer answer = valueAnswer(200, body);
  answer.headers = {{"Cache-Control", "public, max-age=2592000"}};
  return answer;
}

}  // namespace mapwright::simulator
