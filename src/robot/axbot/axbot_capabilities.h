// The capabilities of an Autoxing robot: one object each, on the thread of the robot. They call the link on
// its own thread and return its results.
#pragma once

#include <functional>
#include <unordered_map>

#include "robot/axbot/axbot_link.h"
#include "robot/map_administration.h"
#include "robot/robot.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::axbot {

/// The caller's context and the link. Both outlive the requests of a capability.
struct Line {
  QObject* asker;
  AxbotLink* link;

  /// Runs `job(*link)` on the link's thread.
  template <typename Job>
  void run(Job job) const {
    QMetaObject::invokeMethod(link, [link = link, job = std::move(job)] { job(*link); });
  }
};

class Submaps : public SubmapSource {
 public:
  explicit Submaps(Line line);
  ~Submaps() override;
  Call fetch(const map::SubmapKey& key, Reply reply) override;
  void cancelAll() override;
  void cancel(const map::SubmapKey& key) override;
  void discard(const map::SubmapKey& key, std::int32_t answered_version) override;

 private:
  struct Waiting {
    Reply reply;
    std::shared_ptr<Call::State> state;
  };
  Line line_;
  quint64 last_ = 0;
  std::unordered_map<quint64, Waiting> waiting_;  // by ticket
};

class Catalogue : public MapCatalogue {
 public:
  explicit Catalogue(Line line) : line_(line) {}
  Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) override;
  Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) override;
  Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) override;
  void discardThumbnail(const map::MapKey& key) override;

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
  void discardPicture(const std::string& fingerprint) override;

 private:
  Line line_;
  wire::PendingCalls<map::WholeMap> maps_;
};

class Overview : public OverviewSource {
 public:
  explicit Overview(Line line) : line_(line) {}
  Call fetchOverview(double resolution_m, OutcomeTo<map::WholeMap> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WholeMap> maps_;
};

class Administration : public MapAdministration {
 public:
  /// `changed` is called, on the thread of the robot, before the answer to a change that may have been
  /// applied.
  Administration(Line line, std::function<void()> changed) : line_(line), changed_(std::move(changed)) {}
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;

 private:
  OutcomeTo<map::CatalogueEntry> telling(OutcomeTo<map::CatalogueEntry> reply) const;

  Line line_;
  std::function<void()> changed_;
  wire::PendingCalls<map::CatalogueEntry> changes_;
};

class Topics : public LiveTopics {
 public:
  Topics(Line line, std::shared_ptr<wire::TapPlace> tap) : line_(line), tap_(std::move(tap)) {}
  QStringList known() const override { return knownTopics(); }
  QStringList topicsOf(map::Stream stream) const override;
  void setWanted(const map::Streams& streams, const QStringList& topics) override;
  void setBasics(const Basics& basics) override;
  void setWatching(bool on) override;
  void setTap(FrameTap tap) override { tap_->set(std::move(tap)); }

 private:
  Line line_;
  std::shared_ptr<wire::TapPlace> tap_;
};

}  // namespace mapwright::robot::axbot
