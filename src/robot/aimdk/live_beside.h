// The rosbridge beside an Agibot robot's interface: pose, goal and sensor data. Source:
// docs/protocols/agibot-aimdk.md, "Where the robot is".
#pragma once

#include <memory>
#include <optional>

#include <QObject>

#include "robot/delivery.h"
#include "robot/robot.h"

namespace mapwright::robot::aimdk {

/// The live topics of another robot, without its maps: those of the interface are used. Lives on the robot's
/// thread.
class LiveBeside : public QObject, public LiveTopics, public Delivers {
  Q_OBJECT
 public:
  /// `source` has LiveTopics. `host`: "10.0.0.7:9090", for messages.
  LiveBeside(std::unique_ptr<Robot> source, QString host);

  void connectToRobot();
  void disconnectFromRobot();
  ConnectionState connection() const { return source_->connection(); }
  QDateTime silentSince() const { return silent_since_; }
  QString host() const { return QString::fromStdString(subject_.id); }
  /// As SecondServer says.
  void trustCertificate(const QString& sha256);

  QStringList known() const override { return topics().known(); }
  QStringList topicsOf(map::Stream stream) const override;
  void setWanted(const map::Streams& streams, const QStringList& topics) override;
  void setBasics(const Basics& basics) override { topics().setBasics(basics); }
  void setWatching(bool on) override { topics().setWatching(on); }
  void setTap(FrameTap tap) override { topics().setTap(std::move(tap)); }
  void setDeliveryTap(DeliveryTap tap) override;

 Q_SIGNALS:
  void topicReceived(const mapwright::map::StampedMessage& message);
  void rawReceived(const mapwright::robot::RawMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void topicsChanged();
  void certificateChanged();  // connection().certificate
  void silenceChanged();      // silentSince()

 private:
  LiveTopics& topics() const { return *source_->liveTopics(); }
  void noteLink();
  void tellOff();

  std::unique_ptr<Robot> source_;
  map::Subject subject_;
  bool wanted_ = false;
  QString trusted_;            // SHA-256 to be passed on; empty = none
  std::optional<Fault> told_;  // why it is away
  std::optional<UntrustedCertificate> certificate_;
  QDateTime silent_since_;
};

}  // namespace mapwright::robot::aimdk
