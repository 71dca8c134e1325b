#include "session/catalogue.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <QPointer>

namespace mapwright::session {
namespace {

constexpr std::size_t kThumbnailsAtOnce = 2;  // the map itself goes first

}  // namespace

Catalogue::Catalogue(robot::MapCatalogue* source, QObject* parent) : QObject(parent), source_(source) {}

void Catalogue::setSource(robot::MapCatalogue* source) {
  if (source == source_) return;
  source_ = source;
  if (source_) {
    if (asked_once_) refresh();
    return;
  }
  loading_ = again_ = false;
  entries_.clear();
  as_of_.reset();
  failure_.reset();
  Q_EMIT changed();
}

void Catalogue::refresh() {
  if (!source_) return;
  asked_once_ = true;
  if (loading_) {
    again_ = true;
    return;
  }
  loading_ = true;
  source_->list([self = QPointer<Catalogue>(this)](robot::Outcome<std::vector<map::CatalogueEntry>> answer) {
    if (self) self->onAnswer(std::move(answer));
  });
  Q_EMIT changed();
}

void Catalogue::onAnswer(robot::Outcome<std::vector<map::CatalogueEntry>> answer) {
  if (!source_) return;  // it cannot tell any more
  loading_ = false;
  if (answer) {
    failure_.reset();
    as_of_ = QDateTime::currentDateTime();
    const auto rank = [](const map::CatalogueEntry& row) {
      return std::tuple(int(row.key.kind), row.is_archived, row.index.value_or(1 << 30),
                        -row.created_s.value_or(0));
    };
    std::stable_sort(answer->begin(), answer->end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    // Looking for each in the list would take ever longer, the longer the list.
    std::map<map::MapKey, const map::CatalogueEntry*> known;
    for (const map::CatalogueEntry& row : entries_) known.try_emplace(row.key, &row);
    for (const map::CatalogueEntry& row : *answer) {
      // A new version has a new picture.
      const auto found = known.find(row.key);
      const map::CatalogueEntry* const before = found == known.end() ? nullptr : found->second;
      const bool changed =
          before && (before->map_version != row.map_version || before->modified_s != row.modified_s);
      if (changed) thumbnails_.erase(row.key);
      // Some robots have one only of the map in use.
      if (changed || (before && before->is_current != row.is_current)) {
        asked_.erase(row.key);
        no_thumbnail_.erase(row.key);
      }
    }
    entries_ = std::move(*answer);
  } else {
    failure_ = std::move(answer.error());
  }
  Q_EMIT changed();
  if (std::exchange(again_, false)) refresh();
}

const map::CatalogueEntry* Catalogue::called(const std::string& text) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const auto& row) { return map::toText(row.key) == text; });
  return found == entries_.end() ? nullptr : &*found;
}

QByteArray Catalogue::thumbnail(const map::MapKey& key) {
  if (const auto found = thumbnails_.find(key); found != thumbnails_.end()) return found->second;
  const map::CatalogueEntry* const row = find(key);
  if (source_ && row && row->has_thumbnail && asked_.insert(key).second) {
    wanted_.push_back(key);
    askForThumbnails();
  }
  return {};
}

void Catalogue::discardThumbnail(const map::MapKey& key) {
  if (source_ && thumbnails_.erase(key) > 0) source_->discardThumbnail(key);
}

const map::Failure* Catalogue::noThumbnailReason(const map::MapKey& key) const {
  const auto found = no_thumbnail_.find(key);
  return found == no_thumbnail_.end() || thumbnails_.contains(key) ? nullptr : &found->second;
}

void Catalogue::releaseThumbnails() {
  for (const map::MapKey& key : std::exchange(wanted_, {})) asked_.erase(key);
  const auto calls = thumbnails_in_progress_;  // a cancelled one changes the list
  for (const auto& [key, call] : calls) call.cancel();
}

void Catalogue::askForThumbnails() {
  while (source_ && !wanted_.empty() && thumbnails_in_progress_.size() < kThumbnailsAtOnce) {
    const map::MapKey key = wanted_.front();
    wanted_.erase(wanted_.begin());
    thumbnails_in_progress_[key] =
        source_->thumbnail(key, [self = QPointer<Catalogue>(this), key](robot::Outcome<std::string> answer) {
          if (self) self->onThumbnail(key, std::move(answer));
        });
  }
}

void Catalogue::onThumbnail(const map::MapKey& key, robot::Outcome<std::string> answer) {
  thumbnails_in_progress_.erase(key);
  if (answer) {
    thumbnails_[key] = QByteArray::fromStdString(*answer);
  } else if (answer.error().kind == map::FailureKind::Cancelled) {
    asked_.erase(key);
  } else {
    no_thumbnail_[key] = std::move(answer.error());
  }
  if (thumbnails_.contains(key) || no_thumbnail_.contains(key)) Q_EMIT thumbnailArrived(key);
  askForThumbnails();
}

}  // namespace mapwright::session

#include "moc_catalogue.cpp"
