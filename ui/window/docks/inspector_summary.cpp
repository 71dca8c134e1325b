#include "window/docks/inspector_summary.h"

#include <QGridLayout>
#include <QLocale>
#include <QToolButton>

#include "window/look/icons.h"
#include "window/look/plain_label.h"
#include "window/status/status_text.h"

namespace mapwright::window {

QString slamStateText(const session::Session& session) {
  QString text = QString::fromStdString(session.live().slam.state);
  if (text.isEmpty() && session.book().listReceived()) {
    switch (session.book().slamState()) {
      case map::SlamState::Slam:
        text = QStringLiteral("mapping");
        break;
      case map::SlamState::Positioning:
        text = QStringLiteral("positioning");
        break;
      case map::SlamState::Invalid:
        text = QStringLiteral("inactive");
        break;
    }
  } else if (text == QLatin1String("slam")) {
    text = QStringLiteral("mapping");
  }
  if (text.isEmpty()) return QStringLiteral("–");
  if (session.live().slam.reliable) {
    text += *session.live().slam.reliable ? QStringLiteral(", reliable") : QStringLiteral(", not reliable");
  }
  return text;
}

InspectorSummary::InspectorSummary(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 8, 8, 4);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  state_ = addRow(grid, QStringLiteral("State"));
  uuid_ = addRow(grid, QStringLiteral("Session"), 1);
  uuid_->setElideMode(Qt::ElideMiddle);
  copy_ = new QToolButton(this);
  copy_->setIcon(themedIcon(QStringLiteral("copy")));
  copy_->setIconSize({14, 14});
  copy_->setFixedSize(22, 20);
  copy_->setToolTip(QStringLiteral("Copy the session's uuid"));
  copy_->setAccessibleName(QStringLiteral("Copy the session's uuid"));
  grid->addWidget(copy_, 1, 2);
  submaps_ = addRow(grid, QStringLiteral("Submaps"));
  cache_ = addRow(grid, QStringLiteral("Memory"));
  fetches_ = addRow(grid, QStringLiteral("Fetches"));
  transferred_ = addRow(grid, QStringLiteral("Received"));
  connect(copy_, &QToolButton::clicked, this,
          [this] { Q_EMIT copyWanted(uuid_->text(), QStringLiteral("Session uuid copied")); });
  refresh(nullptr);
}

PlainLabel* InspectorSummary::addRow(QGridLayout* grid, const QString& name, int columns) {
  const int row = grid->rowCount() - (grid->count() == 0 ? 1 : 0);
  auto* label = new PlainLabel(name, this);
  label->setSecondary(true);
  auto* value = new PlainLabel(this);
  value->setObjectName(name.toLower());
  value->setSample(QStringLiteral("x"));  // as wide as the dock lets it be, whatever it says
  value->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grid->addWidget(label, row, 0);
  grid->addWidget(value, row, 1, 1, columns);
  return value;
}

void InspectorSummary::refresh(const session::Session* session) {
  const QString none = QStringLiteral("–");
  copy_->setEnabled(session && !session->book().uuid().empty());
  if (!session) {
    state_->setSecondary(false);
    for (PlainLabel* label : {state_, uuid_, submaps_, cache_, fetches_, transferred_}) label->setText(none);
    return;
  }
  const session::SubmapCounts counts = session->counts();
  state_->setText(slamStateText(*session));
  // What the robot said last is not what it says now.
  const auto stale = session->staleSince();
  if (stale) {
    state_->setText(
        tr("%1 (as of %2)").arg(state_->text(), QLocale::c().toString(*stale, QStringLiteral("HH:mm:ss"))));
  }
  state_->setSecondary(stale.has_value());
  const QString uuid = QString::fromStdString(session->book().uuid());
  uuid_->setText(uuid.isEmpty() ? none : uuid);
  QString submaps =
      counts.list_received
          ? QStringLiteral("%1 in %2")
                .arg(countText(counts.listed),
                     counts.trajectories == 1 ? QStringLiteral("1 trajectory")
                                              : QStringLiteral("%1 trajectories").arg(counts.trajectories))
          : none;
  if (counts.hidden > 0) submaps += QStringLiteral(", %1 hidden").arg(countText(counts.hidden));
  submaps_->setText(submaps);
  cache_->setText(QStringLiteral("%1 of pictures").arg(bytesText(counts.texture_bytes)));
  fetches_->setText(QStringLiteral("%1 in flight, %2 queued, %3 failed")
                        .arg(countText(counts.fetching), countText(counts.queued), countText(counts.failed)));
  transferred_->setText(QStringLiteral("%1 in %2, %3 from disk")
                            .arg(bytesText(qint64(counts.bytes_fetched)),
                                 counts.fetches == 1
                                     ? QStringLiteral("1 answer")
                                     : QStringLiteral("%1 answers").arg(countText(qint64(counts.fetches))),
                                 countText(qint64(counts.cache_hits))));
}

}  // namespace mapwright::window
