#include "jobs/change_map.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::jobs {
namespace {

class ChangeMapText {
  Q_DECLARE_TR_FUNCTIONS(ChangeMap)
};

using robot::MapChange;

bool isOneLine(const QString& name) {
  return std::none_of(name.begin(), name.end(), [](QChar c) { return c.category() == QChar::Other_Control; });
}

}  // namespace

QString noMapNameReason(const QString& name) {
  if (name.trimmed().isEmpty()) return ChangeMapText::tr("A map must have a name.");
  if (!isOneLine(name))
    return ChangeMapText::tr("The name of a map must be one line without control characters.");
  return {};
}

QString alsoCalledSo(const robot::MapOrder& order, const std::vector<map::CatalogueEntry>& maps) {
  constexpr qsizetype kMostNamed = 5;
  const QString name = words::plainName(order.name);
  QStringList ids;
  for (const map::CatalogueEntry& one : maps) {
    if (one.key.kind == map::MapKind::Stored && one.key != order.key && words::plainName(one.name) == name)
      ids << words::plainName(one.key.id);
  }
  if (ids.size() < 2)
    return ids.isEmpty() ? QString()
                         : ChangeMapText::tr("Another map has this name: id %1.").arg(ids.front());
  const QString named = words::listed(ids.mid(0, kMostNamed));
  return ids.size() > kMostNamed
             ? ChangeMapText::tr("Other maps have this name: ids %1 and others.").arg(named)
             : ChangeMapText::tr("Other maps have this name: ids %1.").arg(named);
}

QString noFilenameReason(const QString& name) {
  constexpr qsizetype kMostBytes = 4096;
  if (!name.trimmed().isEmpty() && isOneLine(name) && name.toUtf8().size() <= kMostBytes) return {};
  return ChangeMapText::tr("The name of the file must be one line, such as office.png.");
}

QString oddity(const robot::MapOrder& order, const map::CatalogueEntry& now) {
  const bool names = order.change == MapChange::Rename || order.change == MapChange::Save;
  if (names && now.name != order.name)
    return ChangeMapText::tr("The robot accepted the change, but says that the map is called \"%1\".")
        .arg(words::plainName(now.name));
  if (order.change == MapChange::Load && !now.is_current)
    return ChangeMapText::tr("The robot accepted the change, but still uses another map.");
  if (order.change == MapChange::Archive && !now.is_archived)
    return ChangeMapText::tr("The robot accepted the change, but does not list the map as archived.");
  if (order.change == MapChange::Unarchive && now.is_archived)
    return ChangeMapText::tr("The robot accepted the change, but still lists the map as archived.");
  return {};
}

}  // namespace mapwright::jobs
