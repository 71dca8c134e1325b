// A Cartographer state file behind the port.
#pragma once

#include <QThread>

#include "robot/pbstream/state_reader.h"
#include "robot/pose_graph_source.h"
#include "robot/robot.h"
#include "robot/slam_file.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::pbstream {

/// What comes with the file comes when it is opened, whatever is wanted.
class StateTopics : public LiveTopics {
 public:
  QStringList known() const override;
  QStringList topicsOf(map::Stream stream) const override;
  void setWanted(const map::Streams&, const QStringList&) override {}
  void setWatching(bool) override {}
  void setTap(FrameTap) override {}
};

class StateGraph : public PoseGraphSource {
 public:
  StateGraph(StateReader* reader, map::Subject file) : reader_(reader), file_(std::move(file)) {}
  Call fetch(OutcomeTo<std::shared_ptr<const map::PoseGraph>> reply) override {
    return reader_.ask(file_, std::move(reply), &StateReader::graph);
  }

 private:
  wire::LinkRef<StateReader> reader_;
  map::Subject file_;
};

/// Nothing here accesses the disk: StateReader does.
class StateRobot : public Robot, public SlamFile {
  Q_OBJECT
 public:
  StateRobot(QString address, StateOptions options, QObject* parent = nullptr);
  /// Waits for the records that are being read.
  ~StateRobot() override;

  QString address() const override { return address_; }
  bool isLocal() const override { return true; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override { return identity_; }
  QString slamFilePath() const override { return path_; }
  SubmapSource* submapSource() override { return &submaps_; }
  PoseGraphSource* poseGraphSource() override { return &graph_; }
  LiveTopics* liveTopics() override { return &topics_; }
  Absence unavailableReason(Capability) const override { return {Absence::Reason::LocalFiles, {}}; }

 private:
  void enter(ConnectionPhase phase, const Fault& reason = {});

  QString address_, path_;
  bool wanted_ = false;  // connected, or about to be
  ConnectionState state_;
  RobotIdentity identity_;
  wire::LinkLog link_log_;
  QThread thread_;
  StateReader* reader_;  // lives on thread_, deleted when it ends
  wire::SubmapsOf<StateReader> submaps_;
  StateGraph graph_;
  StateTopics topics_;
};

}  // namespace mapwright::robot::pbstream
