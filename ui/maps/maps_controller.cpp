#include "ui/maps/maps_controller.h"

#include <utility>

#include "map/whereabouts.h"
#include "regions/region_map.h"
#include "sentences/problem_sentence.h"
#include "session/lacks_picture.h"
#include "session/session.h"
#include "ui/kit/findings.h"
#include "ui/kit/panels.h"
#include "ui/maps/map_files.h"
#include "ui/maps/maps_dock.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/map_overlay.h"
#include "ui/view/on_screen.h"
#include "ui/view/toast_stack.h"
#include "words/listed.h"

namespace mapwright::ui {

MapsController::MapsController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), dock_(new MapsDock(&context.window)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Left, .tab = 10, .menu_rank = 10});
  context_.findings.add([this]() -> Findings::Search {
    return [this](const QString&, const Findings::See& see) {
      const session::Session* const session = context_.current.session();
      if (!session) return;
      for (const map::CatalogueEntry& entry : session->catalogue().entries()) {
        see({mapCalled(QString::fromStdString(entry.name), entry.key), tr("Map"), QStringLiteral("map"),
             [this, key = entry.key] { open(key); }});
      }
    };
  });
  connect(dock_, &MapsDock::openWanted, this, &MapsController::open);
  connect(dock_, &MapsDock::compareWanted, this, &MapsController::compareWanted);
  connect(dock_, &MapsDock::alignWanted, this, &MapsController::alignWanted);
  connect(dock_, &MapsDock::exportWanted, this, &MapsController::openToExport);
  connect(dock_, &MapsDock::forgetWanted, this, &MapsController::forget);
  connect(dock_, &MapsDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
  connect(&context_.scene, &scene::MapScene::contentChanged, this, &MapsController::fitNew);
  connect(&context_.scene, &scene::MapScene::layersChanged, this, &MapsController::fitNew);
  connect(&context_.current, &CurrentSession::stateChanged, this, &MapsController::refreshNotice);
  connect(&context_.panels, &Panels::arranged, this, [this] {
    if (catalogueComesFirst()) context_.panels.suggest(dock_);
  });
}

bool MapsController::catalogueComesFirst() const {
  session::Session* const session = context_.current.session();
  return session && !session->robot().submapSource() && session->catalogue().offered();
}

void MapsController::setSession(session::Session* session) {
  dock_->setSession(session);
  fit_next_ = false;
  fitted_.reset();
  export_when_read_.reset();
  changed_.reset();
  listed_.reset();
  if (!session) return;
  connect(&session->catalogue(), &session::Catalogue::changed, this, &MapsController::refreshNotice);
  connect(&session->wholeMap(), &session::MapSlot::changed, this, &MapsController::onMapChanged);
  connect(&session->robot(), &robot::Robot::mapsChanged, this, &MapsController::onOtherFile);
  if (catalogueComesFirst()) context_.panels.suggest(dock_);
}

void MapsController::open(const map::MapKey& key) {
  session::Session* const session = context_.current.session();
  if (!session) return;
  const session::MapSlot& slot = session->wholeMap();
  if (isFetched(key)) {
    context_.scene.setLayerVisible(scene::Layer::WholeMap, true);
    return context_.viewpoint.fit(slot.reference().bounds());
  }
  if (slot.cells() && slot.shown().key == key) return show(key);  // nothing to do
  context_.unsaved.whenMayLeave([this, key] { show(key); });
}

void MapsController::show(const map::MapKey& key) {
  session::Session* const session = context_.current.session();
  if (!session) return;
  // For a robot that sends its map by region that is its live map.
  const regions::RegionMap* const by_region = context_.scene.regions();
  if (key.kind == map::MapKind::Live && by_region && by_region->offered()) return Q_EMIT regionsWanted();
  fit_next_ = true;
  fitted_.reset();
  if (viewMode(context_.scene).value_or(ViewMode::Submaps) == ViewMode::Submaps)
    setViewMode(context_.scene, ViewMode::Whole);
  session->openMap(key);
}

bool MapsController::isFetched(const map::MapKey& key) const {
  const session::Session* const session = context_.current.session();
  if (!session) return false;
  const session::MapSlot& slot = session->wholeMap();
  return slot.cells() && slot.shown().key == key && slot.shown().state_of;
}

void MapsController::forget(const map::MapKey& key) {
  if (isFetched(key)) context_.unsaved.whenMayLeave([this] { Q_EMIT regionsWanted(); });
}

void MapsController::openToExport(const map::MapKey& key) {
  const session::Session* const session = context_.current.session();
  if (!session) return;
  const session::MapSlot& slot = session->wholeMap();
  if (slot.key() == key && slot.phase() == session::MapSlot::Phase::Ready) {
    Q_EMIT exportWanted();
    return;
  }
  export_when_read_ = key;
  open(key);
}

void MapsController::onMapChanged() {
  const session::Session* const session = context_.current.session();
  if (!session || !session->wholeMap().settled()) return;
  const session::MapSlot& slot = session->wholeMap();
  const auto before = std::exchange(changed_, std::nullopt);
  // Files beside the picture may have changed, too.
  const bool other =
      before && (before->fingerprint.empty() || before->fingerprint != slot.shown().fingerprint ||
                 before->grid != slot.shown().grid);
  if (other && slot.phase() == session::MapSlot::Phase::Ready)
    context_.overlay.toasts()->add(
        Mark::Good, tr("%1 changed on disk and was read again.").arg(mapCalled(slot.name(), slot.key())));
  if (!export_when_read_) return;
  const bool wanted = slot.key() == *export_when_read_ && slot.phase() == session::MapSlot::Phase::Ready;
  export_when_read_.reset();
  if (wanted) Q_EMIT exportWanted();
}

QString MapsController::deletedMap(const session::Session& session) {
  const session::Catalogue& catalogue = session.catalogue();
  if (catalogue.loading() || catalogue.failure() || session.robot().isLocal()) return {};
  const session::MapSlot& slot = session.wholeMap();
  const map::MapKey& shown = slot.shown().key;
  const bool gone = listed_ && !catalogue.find(listed_->key);
  const QString called = gone ? mapCalled(QString::fromStdString(listed_->name), listed_->key) : QString();
  if (gone && slot.cells() && shown == listed_->key) {
    deletion_shown_ = true;
    return called;
  }
  // Another one took its place at once.
  if (gone && !deletion_shown_)
    context_.overlay.toasts()->add(Mark::Warning, tr("%1 is not on the robot any more.").arg(called));
  listed_.reset();
  deletion_shown_ = false;
  const map::CatalogueEntry* const entry = slot.cells() ? catalogue.find(shown) : nullptr;
  if (entry && shown.kind != map::MapKind::Live) listed_ = *entry;
  return {};
}

void MapsController::onOtherFile() {
  if (std::exchange(own_change_, false)) return;
  const session::Session* const session = context_.current.session();
  if (!session || !session->robot().isLocal()) return;
  const session::MapSlot& slot = session->wholeMap();
  // Of a recording another time is shown, and nothing has changed on disk.
  if (slot.phase() == session::MapSlot::Phase::Empty || slot.key().kind != map::MapKind::File) return;
  changed_ = slot.shown();
}

void MapsController::fitNew() {
  const session::Session* const session = context_.current.session();
  if (!session || !session->wholeMap().cells()) return;
  const map::MapKey& shown = session->wholeMap().shown().key;
  if (fitted_ == shown || !context_.scene.layerVisible(scene::Layer::WholeMap)) return;
  if (!fit_next_ && (context_.viewpoint.chosen() || context_.scene.layerVisible(scene::Layer::Submaps)))
    return;
  if (fit_next_ && shown != session->wholeMap().key()) return;  // still the previous one
  fitted_ = shown;
  fit_next_ = false;
  context_.viewpoint.fit(context_.scene.contentBounds());
}

void MapsController::refreshNotice() {
  session::Session* const session = context_.current.session();
  const MapsInView in_view = mapsInView(context_.scene);
  const QString deleted = session ? deletedMap(*session) : QString();
  if (!session || !in_view.whole) return context_.notices.clear(NoticeRank::Map);
  const session::MapSlot& slot = session->wholeMap();
  const QString sentence =
      words::about(mapCalled(slot.name(), slot.key()), sentences::sentenceOf(slot.remark()));
  const auto retry = [this] { Q_EMIT retryWanted(); };
  // While there is nothing else on screen the card shows it.
  if (session::lacksPicture(slot) && !emptyState(session, in_view)) {
    context_.notices.set(
        NoticeRank::Map,
        {Mark::Warning,
         (context_.scene.robotPlace().where == map::Whereabouts::Elsewhere
              ? tr("%1 Its waypoints are shown without it. The robot is in another map and hidden.")
              : tr("%1 Its waypoints are shown without it."))
             .arg(sentence),
         {},
         {},
         true});
  } else if (slot.phase() == session::MapSlot::Phase::Failed && !emptyState(session, in_view)) {
    context_.notices.set(NoticeRank::Map, {Mark::Bad, sentence, tr("Retry"), retry});
  } else if (!deleted.isEmpty()) {
    context_.notices.set(
        NoticeRank::Map,
        {Mark::Warning,
         tr("%1 is not on the robot any more. It stays on screen until you open another map.").arg(deleted),
         tr("Export it…"), [this] { Q_EMIT exportWanted(); }, true});
  } else if (slot.phase() == session::MapSlot::Phase::Ready && slot.remark()) {
    context_.notices.set(NoticeRank::Map,
                         {Mark::Warning, sentence, slot.broken() ? tr("Retry") : QString(), retry, true});
  } else {
    context_.notices.clear(NoticeRank::Map);
  }
}

}  // namespace mapwright::ui

#include "moc_maps_controller.cpp"
