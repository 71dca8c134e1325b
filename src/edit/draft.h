// A draft: the unsaved changes of a document, as a value and as bytes. Contains only changed items, each
// before and after, which is all that a three-way merge needs. Pure functions, any thread.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include "edit/document.h"

namespace mapwright::edit {

/// How an item is written into a draft: static write(item) and read(object), for each kind of item.
template <typename Item>
struct ItemJson;

/// Which list of which robot or file a draft belongs to.
struct DraftIdentity {
  QString address, map, kind;  // kind: "waypoints"
  bool operator==(const DraftIdentity&) const = default;
};

template <typename Item>
struct Draft {
  DraftIdentity of;
  QDateTime made;
  std::vector<Change<Item>> changes;
};

/// The envelope around the changes. `changes`: objects with key, before and after (absent = does not exist).
QByteArray draftBytes(const DraftIdentity& of, const QDateTime& made, const QJsonArray& changes);
struct DraftFrame {
  DraftIdentity of;
  QDateTime made;
  QJsonArray changes;
};
/// nullopt = not a draft, or written by a later version.
std::optional<DraftFrame> draftFrame(const QByteArray& bytes);

template <typename Item>
QByteArray toBytes(const Draft<Item>& draft) {
  QJsonArray rows;
  for (const Change<Item>& change : draft.changes) {
    QJsonObject row{{QStringLiteral("key"), QString::fromStdString(change.key)}};
    if (change.before) row[QStringLiteral("before")] = ItemJson<Item>::write(*change.before);
    if (change.after) row[QStringLiteral("after")] = ItemJson<Item>::write(*change.after);
    rows << row;
  }
  return draftBytes(draft.of, draft.made, rows);
}

template <typename Item>
std::optional<Draft<Item>> draftFromBytes(const QByteArray& bytes) {
  const auto frame = draftFrame(bytes);
  if (!frame) return std::nullopt;
  Draft<Item> draft{frame->of, frame->made, {}};
  for (const QJsonValue& value : frame->changes) {
    const QJsonObject row = value.toObject();
    Change<Item> change{row.value(QLatin1String("key")).toString().toStdString()};
    for (const auto& [name, into] : {std::pair{"before", &change.before}, {"after", &change.after}}) {
      const QJsonValue item = row.value(QLatin1String(name));
      if (item.isUndefined()) continue;
      *into = ItemJson<Item>::read(item.toObject());
      if (!*into) return std::nullopt;
    }
    if (change.key.empty() || (!change.before && !change.after)) return std::nullopt;
    draft.changes.push_back(std::move(change));
  }
  return draft;
}

}  // namespace mapwright::edit
