// A recording behind the port: an MCAP file, or a bag of ROS 1 or ROS 2. It has one bag, itself
// (BagKind::File), and the data stored besides its messages. It sends nothing live: replay::ReplayRobot plays
// it.
#pragma once

#include <QThread>

#include "robot/bag_library.h"
#include "robot/recorded/recorded_file.h"
#include "robot/robot.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::recorded {

/// Whether it is called like a recording: .mcap, .bag, .db3, also compressed (.mcap.zstd).
bool hasRecordingName(const QString& path);
/// Whether `path` is a recording, by its name or its first bytes; also a folder that rosbag2 has recorded
/// into.
bool isRecording(const QString& path);
/// The name of its bag.
std::string bagNameOf(const QString& path);

class Library : public BagLibrary {
 public:
  explicit Library(RecordedFile* file) : file_(file) {}
  Call list(OutcomeTo<std::vector<BagEntry>> reply) override;
  Call info(const BagKey& key, OutcomeTo<BagInfo> reply) override;
  Call messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) override;
  Call picture(const std::string& topic, const std::string& url,
               OutcomeTo<std::shared_ptr<const std::string>> reply) override;
  // A file is read-only.
  Call record(const BagOrder& order, OutcomeTo<BagEntry> reply) override;
  Call remove(const BagKey& key, OutcomeTo<BagKey> reply) override;
  Call download(const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply) override;

 private:
  wire::LinkRef<RecordedFile> file_;
};

/// The recorded topics by kind of data. Sends nothing, whatever is wanted.
class Topics : public LiveTopics {
 public:
  void set(const RecordingFacts& facts);
  QStringList known() const override { return known_; }
  QStringList topicsOf(map::Stream stream) const override;
  void setWanted(const map::Streams&, const QStringList&) override {}
  void setWatching(bool) override {}
  void setTap(FrameTap) override {}

 private:
  QStringList known_;
  std::map<map::Stream, QStringList> streams_;
};

/// Nothing here accesses the disk: RecordedFile does. Works without a connection.
class RecordedRobot : public Robot, public OffersTopics {
  Q_OBJECT
 public:
  RecordedRobot(QString address, RecordedOptions options, QObject* parent = nullptr);
  /// Waits for at most one block of a range.
  ~RecordedRobot() override;

  QString address() const override { return address_; }
  bool isLocal() const override { return true; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override { return identity_; }
  SubmapSource* submapSource() override { return &submaps_; }
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return &waypoints_; }
  LiveTopics* liveTopics() override { return &topics_; }
  BagLibrary* bagLibrary() override { return &library_; }
  Absence unavailableReason(Capability) const override { return {Absence::Reason::LocalFiles, {}}; }
  std::optional<std::vector<OfferedTopic>> offered() const override { return facts_.offered; }
  QStringList choicesFor(map::Stream stream) const override;
  void choose(const TopicChoices& choices) override;
  TopicChoices chosen() const override { return chosen_; }

 private:
  void enter(ConnectionPhase phase, const Fault& reason = {});

  QString address_;
  bool wanted_ = false;
  ConnectionState state_;
  wire::LinkLog link_log_;
  RobotIdentity identity_;
  RecordingFacts facts_;
  TopicChoices chosen_;
  QThread thread_;
  RecordedFile* file_;  // lives on thread_, deleted when it ends
  Library library_;
  wire::SubmapsOf<RecordedFile> submaps_;
  wire::CatalogueOf<RecordedFile> catalogue_;
  wire::WholeMapsOf<RecordedFile> whole_maps_;
  wire::WaypointsOf<RecordedFile> waypoints_;
  Topics topics_;
};

}  // namespace mapwright::robot::recorded
