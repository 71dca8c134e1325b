#include "ui/slam/inspector_summary.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLocale>
#include <QToolButton>

#include "sentences/plural.h"
#include "ui/kit/icons.h"
#include "ui/kit/link_text.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"

namespace mapwright::window {

QString slamStateText(const session::Session& session) {
  QString text = QString::fromStdString(session.live().slam.state);
  if (text.isEmpty() && session.submaps().listReceived()) {
    switch (session.submaps().slamState()) {
      case map::SlamState::Slam:
        text = QCoreApplication::translate("window", "mapping");
        break;
      case map::SlamState::Positioning:
        text = QCoreApplication::translate("window", "positioning");
        break;
      case map::SlamState::Invalid:
        // Not reported, or in unknown words.
        text = QCoreApplication::translate("window", "not reported");
        break;
    }
  } else if (text == QLatin1String("slam")) {
    text = QCoreApplication::translate("window", "mapping");
  }
  if (text.isEmpty()) return QStringLiteral("–");
  if (session.live().slam.reliable) {
    text += *session.live().slam.reliable ? QCoreApplication::translate("window", ", reliable")
                                          : QCoreApplication::translate("window", ", not reliable");
  }
  return text;
}

InspectorSummary::InspectorSummary(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 8, 8, 4);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  state_ = addRow(grid, tr("State"));
  uuid_ = addRow(grid, tr("Session"), 1);
  uuid_->setElideMode(Qt::ElideMiddle);
  copy_ = new QToolButton(this);
  copy_->setIcon(themedIcon(QStringLiteral("copy")));
  copy_->setIconSize({14, 14});
  copy_->setFixedSize(22, 20);
  copy_->setToolTip(tr("Copy the session's uuid"));
  copy_->setAccessibleName(tr("Copy the session's uuid"));
  grid->addWidget(copy_, 1, 2);
  submaps_ = addRow(grid, tr("Submaps"));
  cache_ = addRow(grid, tr("Memory"));
  fetches_ = addRow(grid, tr("Fetches"));
  transferred_ = addRow(grid, tr("Received"));
  connect(copy_, &QToolButton::clicked, this,
          [this] { Q_EMIT copyWanted(uuid_->text(), tr("Session uuid copied")); });
  refresh(nullptr);
}

PlainLabel* InspectorSummary::addRow(QGridLayout* grid, const QString& name, int columns) {
  const int row = grid->rowCount() - (grid->count() == 0 ? 1 : 0);
  auto* label = new PlainLabel(name, this);
  label->setSecondary(true);
  auto* value = new PlainLabel(this);
  value->setObjectName(name.toLower());
  value->setSample(QStringLiteral("x"));  // as wide as the dock allows, whatever the text
  value->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grid->addWidget(label, row, 0);
  grid->addWidget(value, row, 1, 1, columns);
  return value;
}

void InspectorSummary::refresh(const session::Session* session) {
  const QString none = QStringLiteral("–");
  copy_->setEnabled(session && !session->submaps().uuid().empty());
  if (!session) {
    state_->setSecondary(false);
    for (PlainLabel* label : {state_, uuid_, submaps_, cache_, fetches_, transferred_}) label->setText(none);
    return;
  }
  const session::SubmapCounts counts = session->counts();
  state_->setText(slamStateText(*session));
  // Old values are not present ones.
  const auto stale = valuesAsOf(*session);
  if (stale) {
    state_->setText(
        tr("%1 (as of %2)").arg(state_->text(), QLocale::c().toString(*stale, QStringLiteral("HH:mm:ss"))));
  }
  state_->setSecondary(stale.has_value());
  const QString uuid = QString::fromStdString(session->submaps().uuid());
  uuid_->setText(uuid.isEmpty() ? none : uuid);
  QString submaps = counts.list_received
                        ? tr("%1 in %2")
                              .arg(countText(counts.listed),
                                   sentences::counted(tr("%1 trajectories", nullptr, counts.trajectories),
                                                      counts.trajectories))
                        : none;
  if (counts.hidden > 0) submaps += tr(", %1 hidden").arg(countText(counts.hidden));
  submaps_->setText(submaps);
  cache_->setText(tr("%1 of pictures").arg(bytesText(counts.texture_bytes)));
  fetches_->setText(tr("%1 in flight, %2 queued, %3 failed")
                        .arg(countText(counts.fetching), countText(counts.queued), countText(counts.failed)));
  transferred_->setText(
      tr("%1 in %2, %3 from disk")
          .arg(bytesText(qint64(counts.bytes_fetched)),
               sentences::counted(tr("%1 answers", nullptr, sentences::formOf(qint64(counts.fetches))),
                                  qint64(counts.fetches)),
               countText(qint64(counts.cache_hits))));
}

}  // namespace mapwright::window

#include "moc_inspector_summary.cpp"
