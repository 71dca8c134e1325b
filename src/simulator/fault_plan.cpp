#include "simulator/fault_plan.h"

#include <algorithm>
#include <utility>

#include "ros_messages/slam.pb.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kMostKeys = 500'000;
constexpr int kLongestDelayMs = 600'000;

}  // namespace

Faults FaultPlan::faults() const {
  const std::lock_guard lock(mutex_);
  return faults_;
}

void FaultPlan::setFaults(const Faults& faults) {
  const std::lock_guard lock(mutex_);
  faults_ = faults;
}

std::uint64_t FaultPlan::next(const std::string& key) {
  if (tries_.size() > kMostKeys) tries_.clear();
  std::uint64_t h = hashOf(seed_, 53, tries_[key]++);
  for (const char c : key) h = mix(h ^ static_cast<unsigned char>(c));
  return h;
}

WriteFault FaultPlan::drawWrite(const std::string& key, std::uint64_t& dice) {
  const std::lock_guard lock(mutex_);
  Dice throws(next(key));
  dice = throws.next();
  double lot = unitFrom(throws.next());
  for (const auto& [rate, fault] : {std::pair{faults_.write_error_rate, WriteFault::Error},
                                    {faults_.drop_writes, WriteFault::Drop},
                                    {faults_.lose_write_answers, WriteFault::LoseAnswer}}) {
    if (lot < rate) return fault;
    lot -= rate;
  }
  return WriteFault::None;
}

Fault FaultPlan::draw(const std::string& key) {
  const std::lock_guard lock(mutex_);
  Dice dice(next(key));

  Fault fault;
  fault.http_status = faults_.error_status;
  fault.dice = dice.next();
  const int jitter = std::clamp(faults_.jitter_ms, 0, kLongestDelayMs);
  fault.delay_ms =
      std::clamp(faults_.latency_ms, 0, kLongestDelayMs) + (jitter > 0 ? dice.integer(0, jitter) : 0);
  double lot = unitFrom(dice.next());
  for (const auto& [rate, kind] : {std::pair{faults_.drop_rate, FaultKind::Drop},
                                   {faults_.truncate_rate, FaultKind::Truncate},
                                   {faults_.wrong_size_rate, FaultKind::WrongSize},
                                   {faults_.corrupt_rate, FaultKind::Corrupt},
                                   {faults_.error_rate, FaultKind::HttpError},
                                   {faults_.status_code_rate, FaultKind::StatusError}}) {
    if (!(rate > 0)) continue;
    if (lot < rate) {
      fault.kind = kind;
      break;
    }
    lot -= rate;
  }
  return fault;
}

std::string withWrongSize(const std::string& body) {
  ros_messages::slam::SubmapQueryV2Response response;
  if (!response.ParseFromString(body)) return body;
  for (ros_messages::slam::SubmapTexture& texture : *response.mutable_textures()) {
    texture.set_width(texture.width() + 7);
    texture.set_height(texture.height() + 3);
  }
  return response.SerializeAsString();
}

std::string garbage(std::uint64_t seed) {
  Dice dice(seed);
  std::string bytes(static_cast<std::size_t>(dice.integer(200, 4000)), '\0');
  for (char& byte : bytes) byte = static_cast<char>(dice.next() & 0xFF);
  bytes[0] = '\x07';  // wire type 7 does not exist: no parser can take it for a message
  return bytes;
}

std::string statusAnswer(int code, const std::string& message) {
  ros_messages::slam::SubmapQueryV2Response response;
  response.mutable_status()->set_code(static_cast<ros_messages::slam::StatusCode>(code));
  response.mutable_status()->set_message(message);
  return response.SerializeAsString();
}

}  // namespace mapwright::simulator
