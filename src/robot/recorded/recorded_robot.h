// A recording behind the port: an MCAP file, or a ROS 1 bag. It has one bag, itself (BagKind::File), and the
// data stored besides its messages. It sends nothing live: replay::ReplayRobot plays it.
#pragma once

#include <QThread>

#include "robot/bag_library.h"
#include "robot/recorded/recorded_file.h"
#include "robot/robot.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::recorded {

/// Whether `path` is a recording, by its extension (.mcap, .bag) or its first bytes.
bool isRecording(const QString& path);
/// The name of its bag.
std::string bagNameOf(const QString& path);

/// The caller's context and the file on its own thread. Both outlive all requests of the capabilities.
struct Line {
  QObject* asker;
  RecordedFile* file;
};

class Library : public BagLibrary {
 public:
  explicit Library(Line line) : line_(line) {}
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
  Line line_;
  wire::PendingCalls<std::vector<BagEntry>> lists_;
  wire::PendingCalls<BagInfo> infos_;
  wire::PendingCalls<BagChunkPtr> chunks_;
  wire::PendingCalls<std::shared_ptr<const std::string>> pictures_;
  wire::PendingCalls<BagEntry> recordings_;
  wire::PendingCalls<BagKey> removals_;
  wire::PendingCalls<BagDownload> downloads_;
};

class Submaps : public SubmapSource {
 public:
  explicit Submaps(Line line) : line_(line) {}
  Call fetch(const map::SubmapKey& key, Reply reply) override;
  void cancelAll() override;
  void cancel(const map::SubmapKey& key) override;

 private:
  void forgetOver();
  Line line_;
  wire::PendingCalls<map::SubmapAnswer> answers_;
  std::vector<std::pair<map::SubmapKey, Call>> calls_;
};

class Catalogue : public MapCatalogue {
 public:
  explicit Catalogue(Line line) : line_(line) {}
  Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) override;
  Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) override;
  Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) override;

 private:
  Line line_;
  wire::PendingCalls<std::vector<map::CatalogueEntry>> lists_;
  wire::PendingCalls<map::CatalogueEntry> descriptions_;
  wire::PendingCalls<std::string> thumbnails_;
};

class WholeMaps : public WholeMapSource {
 public:
  explicit WholeMaps(Line line) : line_(line) {}
  Call fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WholeMap> maps_;
};

class Waypoints : public WaypointSource {
 public:
  explicit Waypoints(Line line) : line_(line) {}
  Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WaypointList> lists_;
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
  Absence whyNot(Capability) const override { return {}; }
  std::optional<std::vector<OfferedTopic>> offered() const override { return facts_.offered; }
  QStringList choicesFor(map::Stream stream) const override;
  void choose(const TopicChoices& choices) override;
  TopicChoices chosen() const override { return chosen_; }

 private:
  void enter(ConnectionPhase phase, const Fault& reason = {});

  QString address_;
  bool wanted_ = false;
  ConnectionState state_;
  RobotIdentity identity_;
  RecordingFacts facts_;
  TopicChoices chosen_;
  QThread thread_;
  RecordedFile* file_;  // lives on thread_, deleted when it ends
  Library library_;
  Submaps submaps_;
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  Waypoints waypoints_;
  Topics topics_;
};

}  // namespace mapwright::robot::recorded
