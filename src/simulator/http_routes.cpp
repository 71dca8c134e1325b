#include "simulator/http_routes.h"

#include <array>
#include <charconv>
#include <optional>

#include "ros_messages/slam.pb.h"
#include "simulator/json_text.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kSubmapPrefix = "/ros/slam/submaps/";
constexpr std::size_t kBodyBudget = std::size_t{64} << 20;

HttpAnswer protobufAnswer(std::shared_ptr<const std::string> body) {
  HttpAnswer answer;
  answer.content_type = "application/x-protobuf";
  answer.body = std::move(body);
  return answer;
}

HttpAnswer statusErrorAnswer(int code, const std::string& message) {
  HttpAnswer answer = protobufAnswer(std::make_shared<const std::string>(statusAnswer(code, message)));
  answer.headers = {{"Cache-Control", "no-cache"}};
  return answer;
}

std::optional<std::int32_t> wholeNumber(std::string_view text) {
  std::int32_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

bool isUuid(std::string_view text) {
  if (text.empty() || text.size() > 64) return false;
  for (const char c : text) {
    const bool fine =
        (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
    if (!fine) return false;
  }
  return true;
}

std::string_view sentenceOf(int status) {
  switch (status) {
    case 400:
      return "Invalid path parameters.";
    case 404:
      return "The submap was not found.";
    case 502:
      return "The ROS service call failed.";
    case 504:
      return "The ROS service was unavailable before the timeout.";
    default:
      return "The answer could not be serialized.";
  }
}

}  // namespace

bool isSubmapPath(std::string_view path) { return path.starts_with(kSubmapPrefix); }

HttpRoutes::HttpRoutes(const RobotState& state, MapLibrary& library, FaultPlan& faults,
                       const Options& options)
    : state_(state),
      faults_(faults),
      secret_(options.secret),
      enable_topic_list_(options.enable_topic_list),
      seed_(options.seed),
      bodies_(kBodyBudget),
      maps_(library, faults) {}

HttpAnswer HttpRoutes::answer(const HttpQuestion& question) {
  if (!allows(question.secret)) return jsonAnswer(401, jsonDetail("A valid Secret header is required."));
  if (question.method != "GET") {
    HttpAnswer answer = jsonAnswer(405, jsonDetail("This robot only answers GET here."));
    answer.headers = {{"Allow", "GET"}};
    return answer;
  }
  const std::string_view path = pathOf(question.target);
  if (isSubmapPath(path)) return submap(question);
  if (path == "/device/info") return deviceInfo();
  if (std::optional<HttpAnswer> answer = maps_.answer(question)) return std::move(*answer);
  return jsonAnswer(404, jsonDetail("Not found."));
}

bool HttpRoutes::isSlow(std::string_view path) const { return path != "/device/info"; }

HttpAnswer HttpRoutes::deviceInfo() const {
  std::string sn = "71822";
  Dice dice(hashOf(seed_, 61));
  for (int i = 0; i < 8; ++i) sn += static_cast<char>('0' + dice.integer(0, 9));
  std::string body =
      R"({"rosversion":"noetic","distro":"focal","axbot_version":"2.11.0","rest_version":"2.11.0",)"
      R"("device":{"model":"hygeia","sn":)";
  appendJsonText(body, sn);
  body += R"(,"name":)";
  appendJsonText(body, "robot-" + sn);
  body +=
      R"(,"nickname":"Simulated robot"},"robot":{"inscribed_radius":0.24,"height":1.23,"thickness":0.5},)"
      R"("caps":{"supportsImuRecalibrateService":true,"supportsShutdownService":true,"supportsSubmaps":true,)"
      R"("supportsEnableTopicList":)";
  body += enable_topic_list_ ? "true" : "false";
  body += "}}";
  return jsonAnswer(200, std::move(body));
}

HttpAnswer HttpRoutes::submap(const HttpQuestion& question) {
  std::array<std::string_view, 3> parts;
  std::string_view rest = pathOf(question.target).substr(kSubmapPrefix.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t slash = i + 1 < parts.size() ? rest.find('/') : std::string_view::npos;
    parts[i] = rest.substr(0, slash);
    rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  }
  const auto trajectory = wholeNumber(parts[1]), index = wholeNumber(parts[2]);
  if (!isUuid(parts[0]) || !trajectory || !index) return jsonAnswer(400, jsonDetail(sentenceOf(400)));

  const Fault fault = faults_.draw(std::string(question.target));
  const std::string uuid = state_.uuid();
  const bool versioned = !queryValue(question.target, "ver").empty();
  const auto answered = [&]() -> HttpAnswer {
    if (fault.kind == FaultKind::HttpError)
      return jsonAnswer(fault.http_status, jsonDetail(sentenceOf(fault.http_status)));
    if (fault.kind == FaultKind::StatusError) {
      using namespace ros_messages::slam;
      constexpr std::array kCodes{INTERNAL, UNAVAILABLE, DEADLINE_EXCEEDED, RESOURCE_EXHAUSTED};
      return statusErrorAnswer(kCodes[fault.dice % kCodes.size()], "The submap could not be queried.");
    }
    if (parts[0] != uuid) {
      return statusErrorAnswer(ros_messages::slam::UUID_MISMATCH, "The SLAM session has another uuid.");
    }
    const std::optional<SubmapSource> source = state_.find({*trajectory, *index});
    if (!source) return jsonAnswer(404, jsonDetail(sentenceOf(404)));

    const std::string tag = '"' + uuid + '-' + std::to_string(*trajectory) + '-' + std::to_string(*index) +
                            '-' + std::to_string(source->version) + '"';
    HttpAnswer answer;
    const bool same = matchesTag(question.if_none_match, tag);
    if (same) {
      answer.status = 304;
      answer.content_type.clear();
    } else {
      answer = protobufAnswer(bodies_.bodyOf(state_.plan(), *source));
    }
    answer.headers = {{"Cache-Control", versioned ? "public, max-age=31536000, immutable" : "no-cache"},
                      {"ETag", versioned ? tag : "W/" + tag}};
    if (same) return answer;
    if (fault.kind == FaultKind::WrongSize) {
      answer.body = std::make_shared<const std::string>(withWrongSize(*answer.body));
    }
    if (fault.kind == FaultKind::Corrupt)
      answer.body = std::make_shared<const std::string>(garbage(fault.dice));
    return answer;
  };
  HttpAnswer answer = fault.kind == FaultKind::Drop ? HttpAnswer{} : answered();
  answer.delay_ms = fault.delay_ms;
  answer.drop = fault.kind == FaultKind::Drop;
  answer.truncate = fault.kind == FaultKind::Truncate && answer.body != nullptr;
  return answer;
}

}  // namespace mapwright::simulator
