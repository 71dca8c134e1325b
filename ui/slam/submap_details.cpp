// The inspector's text about the selected submap.
#include <QCoreApplication>
#include <QStringList>

#include "geometry/pose.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/status_text.h"
#include "ui/slam/inspector_dock.h"

namespace mapwright::window {

QString submapDetails(const session::Session& session, map::SubmapId id) {
  const submap::SubmapRow* row = session.submaps().find(id);
  if (!row)
    return QCoreApplication::translate("window", "Submap %1 is no longer listed.")
        .arg(QString::fromStdString(map::toText(id)));
  QString name =
      QStringLiteral("%1 v%2").arg(QString::fromStdString(map::toText(id))).arg(row->entry.version);
  if (row->visible && row->shown_version >= 0 && row->shown_version != row->entry.version) {
    name += InspectorDock::tr(" (v%1 on screen)").arg(row->shown_version);
  }
  SubmapFacts facts;
  facts.frozen = row->entry.is_frozen;
  facts.incremental = row->entry.is_incremental;
  facts.nearby = row->entry.is_nearby;
  QStringList lines{QStringLiteral("%1  %2").arg(name, badges(facts).join(QLatin1String(" ")).toLower())};
  const auto pose = geometry::toIsometry(row->entry.pose);
  QString where = InspectorDock::tr("no valid pose");
  if (pose && row->pose_usable) {
    const geometry::Pose2 flat = geometry::projectToPlane(*pose);
    where = QStringLiteral("x %1 y %2 m, %3")
                .arg(flat.x_m, 0, 'f', 2)
                .arg(flat.y_m, 0, 'f', 2)
                .arg(rotationText(flat.yaw_rad));
  }
  if (const auto slices = int(row->slices.size()); slices > 0) {
    where += QStringLiteral(", %1, %2")
                 .arg(sentences::counted(InspectorDock::tr("%1 slices", nullptr, slices), slices),
                      bytesText(qint64(row->texture_bytes)));
  }
  lines << where;
  const QString reason = sentences::sentenceOf(session.reason(id));
  lines << (reason.isEmpty() ? statusWord(session.status(id))
                             : QStringLiteral("%1: %2").arg(statusWord(session.status(id)), reason));
  return lines.join(QLatin1Char('\n'));
}

}  // namespace mapwright::window
