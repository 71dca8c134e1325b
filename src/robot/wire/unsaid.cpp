#include "robot/wire/unsaid.h"

#include "net/unsaid.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::wire {

Unsaid::Unsaid(const QByteArray& secret) : secret_(std::make_shared<net::Unsaid>(secret)) {}

void Unsaid::hideIn(std::string& words) const { secret_->hideIn(words); }
void Unsaid::hideIn(QString& words) const { secret_->hideIn(words); }
void Unsaid::hideIn(QByteArray& utf8) const { secret_->hideIn(utf8); }

void Unsaid::hideIn(Fault& fault) const {
  for (FaultArgument& argument : fault.arguments) {
    if (auto* words = std::get_if<std::string>(&argument)) hideIn(*words);
  }
  for (Fault& behind : fault.because) hideIn(behind);
}

void Unsaid::hideIn(map::Failure& failure) const {
  hideIn(failure.robot_code);
  hideIn(failure.detail);
  for (std::string& argument : failure.arguments) hideIn(argument);
  hideIn(failure.cause);
}

void Unsaid::hideIn(map::Problem& problem) const {
  hideIn(problem.reason);
  if (problem.request) hideIn(*problem.request);
}

void Unsaid::hideIn(ConnectionState& state) const { hideIn(state.reason); }

const Unsaid& unsaidOf(const QObject* link) {
  static const Unsaid nothing;
  const auto* const of = qobject_cast<const RobotLink*>(link);
  return of ? of->unsaid() : nothing;
}

}  // namespace mapwright::robot::wire
