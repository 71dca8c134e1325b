#include <array>
#include <cmath>
#include <optional>

#include "ros_messages/slam.pb.h"
#include "simulator/json_text.h"
#include "simulator/map_answers.h"
#include "simulator/routes.h"
#include "simulator/whole_text.h"

namespace mapwright::simulator {
namespace {

constexpr std::string_view kSubmapPrefix = "/ros/slam/submaps/";
constexpr double kFinestM = 0.005, kCoarsestM = 10;
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

HttpRoutes::HttpRoutes(const Robot& robot) : robot_(robot), bodies_(kBodyBudget), bags_(robot) {}

bool HttpRoutes::opensTopics(std::string_view secret) const {
  return robot_.options.secret.empty() || secret == robot_.options.secret;
}

HttpAnswer HttpRoutes::answer(const HttpQuestion& question) {
  if (!opensTopics(question.secret)) return errorAnswer(401, "A valid Secret header is required.");
  if (question.method == "GET") return routed(question);
  if (question.method == "HEAD") {
    HttpQuestion get = question;
    get.method = "GET";
    return routed(get);
  }
  return write(question);
}

HttpAnswer HttpRoutes::write(const HttpQuestion& question) {
  std::uint64_t dice = 0;
  const WriteFault fault =
      robot_.faults.drawWrite(std::string(question.method) + " " + std::string(question.target), dice);
  HttpAnswer answer;
  if (fault == WriteFault::Error) {
    constexpr std::array kStatuses{500, 502, 503};
    answer = errorAnswer(kStatuses[dice % kStatuses.size()], "The request could not be carried out.");
    if (answer.status == 502) {  // as a proxy in front of the robot writes it
      answer.content_type = "text/html";
      answer.body = std::make_shared<const std::string>(
          "<html><head><title>502 Bad Gateway</title></head><body><h1>502 Bad Gateway</h1></body></html>");
    }
  } else if (fault != WriteFault::Drop) {
    answer = routed(question);
  }
  answer.drop = answer.drop || fault == WriteFault::Drop || fault == WriteFault::LoseAnswer;
  answer.delay_ms += robot_.faults.faults().write_latency_ms;
  return answer;
}

HttpAnswer HttpRoutes::routed(const HttpQuestion& question) {
  const std::string_view path = pathOf(question.target);
  if (isSubmapPath(path) || path == "/ros/slam/map_image") {
    if (auto refused = refusedMethod(question, "GET")) return *refused;
    return isSubmapPath(path) ? submap(question) : image(question);
  }
  if (auto answer = deviceAnswer(robot_, question)) return *answer;
  if (auto answer = mapAnswer(robot_, question)) return *answer;
  if (auto answer = mappingAnswer(robot_, question)) return *answer;
  if (auto answer = chassisAnswer(robot_, question)) return *answer;
  if (auto answer = bags_.answer(question)) {
    answer->delay_ms += robot_.faults.faults().map_latency_ms;
    return *answer;
  }
  return notFound();
}

bool HttpRoutes::isSlow(std::string_view path) const { return path != "/device/info"; }

HttpAnswer HttpRoutes::image(const HttpQuestion& question) {
  const std::string_view asked = queryValue(question.target, "resolution");
  PictureSpec spec;
  const std::optional<MappingSpan> span = robot_.state.mapping();
  const bool new_only = queryValue(question.target, "new_trajectory_only") == "true";
  if (span) spec = specOf(*span, new_only);
  const std::optional<double> resolution = asked.empty() ? spec.resolution_m : numberFrom<double>(asked);
  if (!resolution || !std::isfinite(*resolution) || *resolution < kFinestM || *resolution > kCoarsestM) {
    return errorAnswer(400, "The resolution must lie between 0.005 and 10 metres.");
  }
  spec.resolution_m = *resolution;
  if (const std::string_view id = queryValue(question.target, "trajectory_id"); !id.empty()) {
    const std::optional<int> number = numberFrom<int>(id);
    if (!number) return errorAnswer(400, "Invalid query parameters.");
    if (*number >= 0 && *number != spec.trajectory) {
      spec = PictureSpec();
      spec.resolution_m = *resolution;
      spec.trajectory = *number;
    }
  }
  const MapPicturePtr made = robot_.library.pictures().picture(spec);
  if (!made) return errorAnswer(502, "The ROS service call failed.");
  ros_messages::slam::GetMapImageResponse response;
  response.set_origin_x(made->origin_m.x());
  response.set_origin_y(made->origin_m.y());
  response.set_resolution(made->resolution_m);
  response.set_png_bytes(faultyPng(*made->png, robot_.faults.faults()));
  HttpAnswer answer = protobufAnswer(std::make_shared<const std::string>(response.SerializeAsString()));
  answer.headers = {{"Cache-Control", "no-cache"}};
  answer.delay_ms = robot_.faults.faults().map_latency_ms;
  return answer;
}

HttpAnswer HttpRoutes::submap(const HttpQuestion& question) {
  std::array<std::string_view, 3> parts;
  std::string_view rest = pathOf(question.target).substr(kSubmapPrefix.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t slash = i + 1 < parts.size() ? rest.find('/') : std::string_view::npos;
    parts[i] = rest.substr(0, slash);
    rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  }
  const auto trajectory = numberFrom<std::int32_t>(parts[1]), index = numberFrom<std::int32_t>(parts[2]);
  if (!isUuid(parts[0]) || !trajectory || !index) return errorAnswer(400, sentenceOf(400));

  const Fault fault = robot_.faults.draw(std::string(question.target));
  const std::string uuid = robot_.state.uuid();
  const bool versioned = !queryValue(question.target, "ver").empty();
  const auto answered = [&]() -> HttpAnswer {
    if (fault.kind == FaultKind::HttpError)
      return errorAnswer(fault.http_status, sentenceOf(fault.http_status));
    if (fault.kind == FaultKind::StatusError) {
      using namespace ros_messages::slam;
      constexpr std::array kCodes{INTERNAL, UNAVAILABLE, DEADLINE_EXCEEDED, RESOURCE_EXHAUSTED};
      return statusErrorAnswer(kCodes[fault.dice % kCodes.size()], "The submap could not be queried.");
    }
    if (parts[0] != uuid) {
      return statusErrorAnswer(ros_messages::slam::UUID_MISMATCH, "The SLAM session has another uuid.");
    }
    const std::optional<SubmapSource> source = robot_.state.find({*trajectory, *index});
    if (!source) return errorAnswer(404, sentenceOf(404));

    const std::string tag = '"' + uuid + '-' + std::to_string(*trajectory) + '-' + std::to_string(*index) +
                            '-' + std::to_string(source->version) + '"';
    HttpAnswer answer;
    const bool same = matchesTag(question.if_none_match, tag);
    if (same) {
      answer.status = 304;
      answer.content_type.clear();
    } else {
      answer = protobufAnswer(bodies_.bodyOf(robot_.state.plan(), *source));
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
