#include "ui/maps/administration_controller.h"

#include <utility>

#include <QMenu>

#include "sentences/absence_sentence.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"

namespace mapwright::window {

using robot::MapChange;
using robot::Obstacle;

AdministrationController::AdministrationController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  const auto add = [this](MapChange change, const char* id, const QString& text, const QString& tip,
                          int rank) {
    QAction* const action =
        context_.actions.add({.id = id, .text = text, .tip = tip, .menu = {MenuGroup::Mapping, rank}}, this,
                             [this, change] { ask(change, nullptr); });
    action->setProperty("tip", action->toolTip());
    mapping_.push_back({change, action});
  };
  add(MapChange::StartMapping, "startMapping", tr("Start &mapping…"), tr("Make the robot start a new map"),
      10);
  add(MapChange::StopMapping, "stopMapping", tr("S&top mapping…"), tr("Make the robot finish its new map"),
      20);
  add(MapChange::Save, "saveNewMap", tr("Save the &new map…"),
      tr("Store the map that the robot has made, under a name"), 30);
  connect(&context_.current, &CurrentSession::stateChanged, this, &AdministrationController::refresh);
  refresh();
}

robot::MapAdministration* AdministrationController::maps() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().mapAdministration() : nullptr;
}

void AdministrationController::setSession(session::Session* session) {
  delete dialog_;  // its question concerns the robot that is left
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &AdministrationController::refresh);
    connect(&session->robot(), &robot::Robot::mapsChanged, this, &AdministrationController::refresh);
  }
  refresh();
}

void AdministrationController::refresh() {
  const robot::MapAdministration* const robots = maps();
  for (const Row& row : mapping_) {
    const auto obstacle = robots ? robots->obstacle(row.change, nullptr) : Obstacle::NotOffered;
    row.action->setVisible(obstacle != Obstacle::NotOffered);
    row.action->setEnabled(!obstacle);
    const QString tip = row.action->property("tip").toString();
    row.action->setToolTip(obstacle ? plainToolTip(sentences::whyNotNow(row.change, *obstacle)) : tip);
  }
}

void AdministrationController::fillMenu(QMenu* menu, const map::MapKey& key) {
  const robot::MapAdministration* const robots = maps();
  session::Session* const session = context_.current.session();
  const map::CatalogueEntry* const map = session ? session->catalogue().find(key) : nullptr;
  if (!robots || !map) return;
  struct Entry {
    MapChange change;
    QString text;
  };
  bool first = true;
  for (const Entry& entry :
       {Entry{MapChange::Load, tr("Load on the robot…")},
        Entry{MapChange::Rename, tr("Rename on the robot…")}, Entry{MapChange::Archive, tr("Archive…")},
        Entry{MapChange::Unarchive, tr("Restore from the archive…")},
        Entry{MapChange::Delete, tr("Delete from the robot…")}}) {
    const auto obstacle = robots->obstacle(entry.change, map);
    const bool pointless = obstacle == Obstacle::NotOffered || obstacle == Obstacle::IsNotArchived ||
                           (entry.change == MapChange::Archive && obstacle == Obstacle::IsArchived);
    if (pointless) continue;
    if (std::exchange(first, false)) menu->addSeparator();
    QAction* const action = menu->addAction(entry.text, this, [this, change = entry.change, key] {
      session::Session* const now = context_.current.session();
      if (const map::CatalogueEntry* const entry_now = now ? now->catalogue().find(key) : nullptr)
        ask(change, entry_now);
    });
    action->setEnabled(!obstacle);
    if (obstacle) action->setToolTip(plainToolTip(sentences::whyNotNow(entry.change, *obstacle)));
  }
}

void AdministrationController::ask(MapChange change, const map::CatalogueEntry* map) {
  robot::MapAdministration* const robots = maps();
  session::Session* const session = context_.current.session();
  if (!robots || !session || (dialog_ && dialog_->waiting())) return;
  delete dialog_;
  ChangeQuestion question = questionFor(change, map, session->catalogue().current());
  question.asks_place = change == MapChange::Load && robots->loadAsksForPlace();
  const bool places = question.asks_place;
  dialog_ = new ChangeDialog(
      std::move(question),
      [this](const robot::MapOrder& order, robot::OutcomeTo<map::CatalogueEntry> reply) {
        // It may have disappeared since the question was asked; then its answer says so, later, as always.
        if (robot::MapAdministration* const now = maps()) return now->carryOut(order, std::move(reply));
        QMetaObject::invokeMethod(
            this,
            [order, reply = std::move(reply)] {
              reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                                     .subject = map::subjectOf(order.key),
                                                     .asked_for = map::AskedFor::Change,
                                                     .reason = map::FailureReason::NotOffered}));
            },
            Qt::QueuedConnection);
        return robot::Call();
      },
      &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &ChangeDialog::done, this,
          [this, change](const map::CatalogueEntry&, const QString& said, bool as_asked) {
            context_.overlay.toasts()->add(as_asked ? Mark::Good : Mark::Warning, said);
            if (session::Session* const now = context_.current.session()) now->catalogue().refresh();
            // After mapping the user usually wants to save the map; not within this call, since its dialog is
            // closing.
            if (change == MapChange::StopMapping) {
              QMetaObject::invokeMethod(
                  this,
                  [this] {
                    const robot::MapAdministration* const still = maps();
                    if (still && !still->obstacle(MapChange::Save, nullptr)) ask(MapChange::Save, nullptr);
                  },
                  Qt::QueuedConnection);
            }
          });
  if (places) askForPlaces(map->key);
  dialog_->open();
}

void AdministrationController::askForPlaces(const map::MapKey& key) {
  session::Session* const session = context_.current.session();
  robot::WaypointSource* const points = session ? session->robot().waypointSource() : nullptr;
  if (!points) return;
  points->waypoints(key, [dialog = dialog_](const robot::Outcome<map::WaypointList>& list) {
    if (dialog && list) dialog->setPlaces(placesToStand(list->points));
  });
}

}  // namespace mapwright::window

#include "moc_administration_controller.cpp"
