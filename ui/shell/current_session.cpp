#include "ui/shell/current_session.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <QPointer>

#include "replay/replay_robot.h"
#include "robot/has_capability.h"
#include "session/session_options.h"
#include "ui/scene/map_scene.h"
#include "ui/view/on_screen.h"

namespace mapwright::ui {

namespace {

constexpr int kBagMapWithinMs = 1'000;  // the map of a bag is there with its state, or not at all

/// In a replay the time of day is the recorded one, and the robot's former problems are not present ones.
session::Session::Options optionsOf(robot::Robot& robot, session::Session::Options options) {
  auto* const replayed = qobject_cast<replay::ReplayRobot*>(&robot);
  if (!replayed) return options;
  options.log_safety = false;
  options.live_map_within_ms = kBagMapWithinMs;
  options.wall = [replay = QPointer(replayed)] {
    const auto at_s = replay ? replay->at() : std::nullopt;
    return at_s ? QDateTime::fromMSecsSinceEpoch(qint64(*at_s * 1000)) : QDateTime::currentDateTime();
  };
  return options;
}

}  // namespace

CurrentSession::CurrentSession(scene::MapScene& scene, session::Session::Options options,
                               robot::Addresses addresses, QObject* parent)
    : QObject(parent),
      scene_(scene),
      options_(std::make_unique<session::Session::Options>(std::move(options))),
      addresses_(std::move(addresses)) {
  options_->log_safety = true;
  connect(&scene_, &scene::MapScene::layersChanged, this, &CurrentSession::stateChanged);
}

CurrentSession::~CurrentSession() { leave(); }

QString CurrentSession::address() const { return session_ ? session_->robot().address() : QString(); }

QString CurrentSession::called() const {
  if (!session_) return {};
  return called_.isEmpty() ? robotCalled(session_->robot(), addresses_) : called_;
}

void CurrentSession::setCalled(const QString& by_user) {
  if (by_user == called_) return;
  called_ = by_user;
  Q_EMIT stateChanged();
}

void CurrentSession::begin(std::unique_ptr<robot::Robot> robot) {
  if (!session_ || !qobject_cast<replay::ReplayRobot*>(&session_->robot())) before_replay_ = address();
  leave();
  called_.clear();
  const session::Session::Options options = optionsOf(*robot, *options_);
  session_ = std::make_unique<session::Session>(std::move(robot), options);
  scene_.setSession(session_.get());
  watch();
  Q_EMIT changed(session_.get());
  session_->open();
  Q_EMIT stateChanged();
}

void CurrentSession::watch() {
  const session::Session* const session = session_.get();
  const auto forward = [this](auto* source, auto signal) {
    connect(source, signal, this, &CurrentSession::stateChanged);
  };
  forward(session, &session::Session::connectionChanged);
  forward(session, &session::Session::identityChanged);
  forward(&session_->robot(), &robot::Robot::capabilitiesChanged);
  forward(session, &session::Session::listChanged);
  forward(session, &session::Session::rowsChanged);
  forward(&session_->wholeMap(), &session::MapSlot::changed);
  forward(&session_->comparedMap(), &session::MapSlot::changed);
  forward(&session_->catalogue(), &session::Catalogue::changed);
  connect(session, &session::Session::liveChanged, this, [this](int what) {
    if (what == map::topicIndex<map::MapInfo>()) Q_EMIT stateChanged();
  });
}

void CurrentSession::leave() {
  if (!session_) return;
  const std::unique_ptr<session::Session> leaving = std::move(session_);
  for (QObject* source :
       std::initializer_list<QObject*>{leaving.get(), &leaving->robot(), &leaving->wholeMap(),
                                       &leaving->comparedMap(), &leaving->catalogue()}) {
    source->disconnect(this);
  }
  Q_EMIT changed(nullptr);
  // The scene shows it until everybody else has released it.
  scene_.setSession(nullptr);
  leaving->close();
  Q_EMIT stateChanged();
}

std::function<bool()> lacksForGood(CurrentSession& current, std::vector<robot::Capability> capabilities) {
  return [&current, capabilities = std::move(capabilities)] {
    session::Session* const open = current.session();
    return open && std::all_of(capabilities.begin(), capabilities.end(), [&](robot::Capability capability) {
             return robot::lacksForGood(open->robot(), capability);
           });
  };
}

}  // namespace mapwright::ui

#include "moc_current_session.cpp"
