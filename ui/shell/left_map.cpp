#include "ui/shell/left_map.h"

#include <QCoreApplication>
#include <QDateTime>

#include "session/session.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"

namespace mapwright::window {

void LeftMap::onLeft(const map::MapKey& map, const QString& sentence) {
  map_ = map;
  // With the time: what happens again is said again, also after the strip was closed.
  const QString said = QCoreApplication::translate("window", "The robot changed to another map at %1. %2")
                           .arg(context_.edit.now().toString(QStringLiteral("HH:mm:ss")), sentence);
  context_.notices.set(NoticeRank::Draft,
                       {Mark::Warning, said, QCoreApplication::translate("window", "Show it"),
                        [context = &context_, map] {
                          if (session::Session* const session = context->current.session())
                            session->openMap(map);
                        },
                        true});
}

void LeftMap::onOpened(const std::optional<map::MapKey>& map) {
  if (map && map == map_) clear();
}

void LeftMap::clear() {
  if (map_) context_.notices.clear(NoticeRank::Draft);
  map_.reset();
}

}  // namespace mapwright::window
