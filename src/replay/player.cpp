#include "replay/player.h"

#include <algorithm>
#include <cmath>

namespace mapwright::replay {

Player::Player(double start_s, double end_s)
    : start_s_(start_s), end_s_(std::max(start_s, end_s)), from_s_(start_s) {}

void Player::extend(double end_s) { end_s_ = std::max(end_s_, end_s); }

double Player::last() const { return until_s_ && *until_s_ > from_s_ ? std::min(*until_s_, end_s_) : end_s_; }

double Player::unbounded(Millis now) const {
  return playing_ && !waiting_ ? from_s_ + double(now - since_) / 1000 * speed_ : from_s_;
}

double Player::at(Millis now) const {
  const double at_s = unbounded(now);
  const bool inside = loop_ && from_s_ >= loop_->from_s && from_s_ <= loop_->until_s;
  if (!inside) return std::clamp(at_s, start_s_, std::max(start_s_, last()));
  const double length_s = loop_->until_s - loop_->from_s;
  const double into_s = std::fmod(at_s - loop_->from_s, length_s);
  // Its end belongs to it as long as nothing goes beyond.
  if (at_s >= loop_->from_s && at_s <= loop_->until_s) return at_s;
  return loop_->from_s + (into_s < 0 ? into_s + length_s : into_s);
}

bool Player::playing(Millis now) const {
  if (!playing_) return false;
  if (loop_) return true;
  const double at_s = unbounded(now);
  return speed_ > 0 ? at_s < last() : at_s > start_s_;
}

void Player::settle(Millis now) {
  const bool goes_on = playing(now);
  from_s_ = at(now);
  playing_ = goes_on;
  since_ = now;
}

void Player::play(Millis now) {
  settle(now);
  // At the end it starts over.
  if (!loop_ && speed_ > 0 && from_s_ >= end_s_) from_s_ = start_s_;
  if (!loop_ && speed_ < 0 && from_s_ <= start_s_) from_s_ = end_s_;
  if (loop_ && (from_s_ < loop_->from_s || from_s_ > loop_->until_s)) from_s_ = loop_->from_s;
  playing_ = true;
}

void Player::pause(Millis now) {
  settle(now);
  playing_ = false;
}

void Player::setSpeed(double speed, Millis now) {
  settle(now);
  if (std::isnan(speed)) return;
  speed_ = std::copysign(std::clamp(std::abs(speed), kSlowest, kFastest), speed);
}

void Player::seek(double at_s, Millis now) {
  settle(now);
  if (!std::isnan(at_s)) from_s_ = std::clamp(at_s, start_s_, end_s_);
}

void Player::step(double by_s, Millis now) {
  pause(now);
  seek(from_s_ + by_s, now);
}

void Player::setWaiting(bool waiting, Millis now) {
  if (waiting == waiting_) return;
  settle(now);
  waiting_ = waiting;
}

void Player::setLoop(std::optional<Loop> loop, Millis now) {
  settle(now);
  if (loop) {
    loop->from_s = std::clamp(loop->from_s, start_s_, end_s_);
    loop->until_s = std::clamp(loop->until_s, start_s_, end_s_);
    if (!(loop->until_s > loop->from_s)) loop.reset();
  }
  loop_ = loop;
}

void Player::playUntil(std::optional<double> until_s, Millis now) {
  settle(now);
  until_s_ = until_s;
  if (until_s) play(now);
}

}  // namespace mapwright::replay
