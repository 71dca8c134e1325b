// Capabilities that do no more than ask what lives on the thread of a link (LinkRef): the same for robots,
// files and recordings.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/bag_library.h"
#include "robot/robot.h"
#include "robot/waypoint_store.h"
#include "robot/wire/failures.h"
#include "robot/wire/link_ref.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::wire {

inline const map::Subject kMapList{map::SubjectKind::Catalogue, map::kMapsPart};
inline const map::Subject kBagList{map::SubjectKind::Catalogue, map::kBagsPart};
inline const map::Subject kRecordingList{map::SubjectKind::Catalogue, map::kRecordingsPart};

/// list() and describe() of `Maps`; where it has no thumbnail(), there are none.
template <typename Maps>
class CatalogueOf : public MapCatalogue {
 public:
  template <typename... Link>
  explicit CatalogueOf(Link... link) : maps_(link...) {}
  Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) override {
    return maps_.ask(kMapList, std::move(reply), &Maps::list);
  }
  Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) override {
    return maps_.ask(map::subjectOf(key), std::move(reply), &Maps::describe, key);
  }
  Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) override {
    if constexpr (requires { &Maps::thumbnail; }) {
      return maps_.ask(map::subjectOf(key), std::move(reply), &Maps::thumbnail, key);
    } else {
      return maps_.refuse(std::move(reply), notOffered(map::subjectOf(key), map::AskedFor::SmallPicture));
    }
  }
  void discardThumbnail(const map::MapKey& key) override {
    if constexpr (requires { &Maps::discardThumbnail; }) maps_.post(&Maps::discardThumbnail, key);
  }

 private:
  LinkRef<Maps> maps_;
};

/// fetch() of `Maps`, and its discardPicture() where it keeps pictures.
template <typename Maps>
class WholeMapsOf : public WholeMapSource {
 public:
  template <typename... Link>
  explicit WholeMapsOf(Link... link) : maps_(link...) {}
  Call fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) override {
    return maps_.ask(map::subjectOf(key), std::move(reply), &Maps::fetch, key);
  }
  void discardPicture(const std::string& fingerprint) override {
    if constexpr (requires { &Maps::discardPicture; }) maps_.post(&Maps::discardPicture, fingerprint);
  }

 private:
  LinkRef<Maps> maps_;
};

/// submap() of `Maps`, and its discardSubmap() where it keeps them.
template <typename Maps>
class SubmapsOf : public SubmapSource {
 public:
  template <typename... Link>
  explicit SubmapsOf(Link... link) : maps_(link...) {}
  Call fetch(const map::SubmapKey& key, Reply reply) override {
    std::erase_if(calls_, [](const auto& one) { return one.second.over(); });
    Call call = maps_.ask(
        map::subjectOf(key.id),
        OutcomeTo<map::SubmapAnswer>([key, reply = std::move(reply)](Outcome<map::SubmapAnswer> outcome) {
          if (outcome) return reply(std::move(*outcome));
          map::SubmapAnswer cancelled;
          cancelled.key = key;
          cancelled.outcome = map::SubmapAnswer::Outcome::Cancelled;
          cancelled.failure = outcome.error().kind;
          reply(std::move(cancelled));
        }),
        &Maps::submap, key);
    calls_.emplace_back(key, call);
    return call;
  }
  void cancelAll() override {
    for (const auto& [key, call] : std::exchange(calls_, {})) call.cancel();
  }
  void cancel(const map::SubmapKey& key) override {
    for (const auto& [of, call] : calls_) {
      if (of == key) call.cancel();
    }
  }
  void discard(const map::SubmapKey& key, std::int32_t answered_version) override {
    if constexpr (requires { &Maps::discardSubmap; }) maps_.post(&Maps::discardSubmap, key, answered_version);
  }

 private:
  LinkRef<Maps> maps_;
  std::vector<std::pair<map::SubmapKey, Call>> calls_;
};

/// waypoints() of `Maps`.
template <typename Maps>
class WaypointsOf : public WaypointSource {
 public:
  explicit WaypointsOf(Maps* maps) : maps_(maps) {}
  Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) override {
    return maps_.ask(map::placesOf(key), std::move(reply), &Maps::waypoints, key);
  }

 private:
  LinkRef<Maps> maps_;
};

/// The lists of a store, to be looked at.
class WaypointsOfStore : public WaypointSource {
 public:
  /// `store` outlives this.
  explicit WaypointsOfStore(WaypointStore& store) : store_(store) {}
  Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) override {
    return store_.read(key, [reply = std::move(reply)](Outcome<StoredWaypoints> stored) {
      if (!stored) return reply(fail(std::move(stored.error())));
      reply(map::WaypointList{std::move(stored->points), std::move(stored->notes)});
    });
  }

 private:
  WaypointStore& store_;
};

/// Those that a robot keeps itself.
template <typename Bags>
class BagsOf : public BagLibrary {
 public:
  template <typename... Link>
  explicit BagsOf(Link... link) : bags_(link...) {}
  Call list(OutcomeTo<std::vector<BagEntry>> reply) override {
    return bags_.ask(kBagList, std::move(reply), &Bags::list);
  }
  Call info(const BagKey& key, OutcomeTo<BagInfo> reply) override {
    return bags_.ask(subjectOf(key), std::move(reply), &Bags::info, key);
  }
  Call messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) override {
    return bags_.ask(subjectOf(key), std::move(reply), &Bags::messages, key, range);
  }
  Call picture(const std::string& topic, const std::string& url,
               OutcomeTo<std::shared_ptr<const std::string>> reply) override {
    return bags_.ask({map::SubjectKind::Topic, topic}, std::move(reply), &Bags::picture, topic, url);
  }
  Call record(const BagOrder& order, OutcomeTo<BagEntry> reply) override {
    return bags_.change(kRecordingList, std::move(reply), &Bags::record, order);
  }
  Call remove(const BagKey& key, OutcomeTo<BagKey> reply) override {
    return bags_.change(subjectOf(key), std::move(reply), &Bags::remove, key);
  }
  Call download(const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply) override {
    return bags_.ask(subjectOf(key), std::move(reply), &Bags::download, key, path);
  }

 private:
  LinkRef<Bags> bags_;
};

/// What of LiveTopics a link is told. Which topics there are is another question.
template <typename Link>
class TopicsOf : public LiveTopics {
 public:
  explicit TopicsOf(Link* link) : link_(link), outputs_(link->outputs()) {}
  void setWanted(const map::Streams& streams, const QStringList& topics) override {
    link_.post(&Link::setWanted, streams, topics);
  }
  void setBasics(const Basics& basics) override { link_.post(&Link::setBasics, basics); }
  void setWatching(bool on) override { link_.post(&Link::setWatching, on); }
  void setTap(FrameTap tap) override { outputs_->tap.set(std::move(tap)); }

 private:
  LinkRef<Link> link_;
  std::shared_ptr<LinkOutputs> outputs_;
};

}  // namespace mapwright::robot::wire
