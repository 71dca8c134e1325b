#include "ui/objects/objects_controller.h"

#include <cmath>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QMenu>

#include "sentences/plural.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/findings.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/panels.h"
#include "ui/kit/status_text.h"
#include "ui/objects/object_card.h"
#include "ui/objects/object_facts.h"
#include "ui/objects/objects_dock.h"
#include "ui/objects/properties_dock.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"

namespace mapwright::ui {

namespace {

constexpr int kDwellMs = 350;    // the cursor rests: what is under it is told
constexpr int kRefreshMs = 250;  // what was chosen changes no faster than this
constexpr int kListMs = 1000;
constexpr int kAgeMs = 1000;
constexpr double kSamePx = 4;  // a click at the same position
constexpr std::size_t kMostListed = 20'000;
constexpr int kMostInMenu = 8;
constexpr double kRoomAroundM = 1;

bool near(const QPointF& a, const QPointF& b, double px) {
  return std::hypot(a.x() - b.x(), a.y() - b.y()) <= px;
}

/// Beside `thing` within `room`; nullopt: one would cover the other.
std::optional<QPoint> positionBeside(const QRect& thing, const QSize& size, const QRect& room) {
  const int right = room.right() + 1 - size.width(), bottom = room.bottom() + 1 - size.height();
  if (right < room.left() || bottom < room.top()) return std::nullopt;
  const int x = std::clamp(thing.right() + 1, room.left(), right);
  const int y = std::clamp(thing.bottom() + 1, room.top(), bottom);
  const QRect corners(room.topLeft(), QPoint(right, bottom));
  for (const QPoint& corner : {QPoint(thing.right() + 1, y), QPoint(thing.left() - size.width(), y),
                               QPoint(x, thing.bottom() + 1), QPoint(x, thing.top() - size.height())}) {
    if (corners.contains(corner)) return corner;
  }
  return std::nullopt;
}

QPointF toPixel(const scene::MapScene& scene, const Eigen::Vector2d& world_m) {
  const Eigen::Vector2d px = scene.view().pixelFromWorld(world_m);
  return {px.x(), px.y()};
}

}  // namespace

ObjectsController::ObjectsController(WindowContext& context, QObject* parent, std::function<QDateTime()> wall)
    : Controller(parent),
      context_(context),
      wall_(std::move(wall)),
      card_(new ObjectCard(context.scene, &context.view)),
      properties_(new PropertiesDock(context.scene, &context.window)),
      dock_(new ObjectsDock(context.scene, &context.window)),
      tasks_(context.workers) {
  context_.panels.add(properties_,
                      {.side = PanelPosition::Side::Right, .tab = 40, .menu_rank = 34, .open = false});
  context_.panels.add(dock_, {.side = PanelPosition::Side::Left, .tab = 30, .menu_rank = 32, .open = false});
  for (const auto& [timer, ms] : {std::pair(&hover_timer_, kDwellMs), std::pair(&refresh_timer_, kRefreshMs),
                                  std::pair(&list_timer_, kListMs)}) {
    timer->setSingleShot(true);
    timer->setInterval(ms);
  }
  age_timer_.setInterval(kAgeMs);
  connect(&hover_timer_, &QTimer::timeout, this, &ObjectsController::hover);
  connect(&refresh_timer_, &QTimer::timeout, this, &ObjectsController::refresh);
  connect(&list_timer_, &QTimer::timeout, this, &ObjectsController::list);
  connect(&age_timer_, &QTimer::timeout, this, &ObjectsController::refresh);
  connect(&context_.view, &MapView::cursorMoved, this, &ObjectsController::cursorMoved);
  // The card would lie over what is to be clicked with the tool.
  connect(&context_.tools, &ToolChoice::chosenChanged, this, &ObjectsController::letGo);
  connect(&context_.scene, &scene::MapScene::viewChanged, this, &ObjectsController::positionCard);
  connect(&context_.scene, &scene::MapScene::layersChanged, this, &ObjectsController::refreshSoon);
  connect(&context_.scene, &scene::MapScene::contentChanged, this, &ObjectsController::refreshSoon);
  connect(card_, &ObjectCard::closeWanted, this, &ObjectsController::letGo);
  connect(card_, &ObjectCard::copyWanted, this, &ObjectsController::copyChosen);
  connect(card_, &ObjectCard::propertiesWanted, this, [this] {
    context_.panels.open(properties_);
    refresh();
  });
  connect(card_, &ObjectCard::nextWanted, this, [this] { pick(card_at_m_, true); });
  connect(properties_, &PropertiesDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
  connect(properties_, &PropertiesDock::locateWanted, this, [this] {
    if (chosen_) context_.viewpoint.lookAt(chosen_->bounds().grown(kRoomAroundM));
  });
  connect(properties_, &QDockWidget::visibilityChanged, this, &ObjectsController::refreshSoon);
  connect(dock_, &ObjectsDock::chosen, this, [this](const scene::ObjectId& id) {
    if (const auto object = context_.scene.object(id)) choose(id, object->at_m, 0);
  });
  connect(dock_, &ObjectsDock::locateWanted, this, &ObjectsController::locate);
  connect(dock_, &ObjectsDock::shown, this, &ObjectsController::list);
  addActions();
  addToMapMenu();
  addFindings();
  connect(&context_.current, &CurrentSession::stateChanged, this, &ObjectsController::allowMap);
  allowMap();
}

void ObjectsController::addActions() {
  context_.actions.add({.id = "identify",
                        .text = tr("&What is this?"),
                        .icon = "info",
                        .keys = {"Ctrl+I"},
                        .tip = tr("Show what is under the cursor; again for what lies beneath it"),
                        .needs_session = true,
                        .menu = {MenuGroup::Look, 30}},
                       this, &ObjectsController::identify);
  map_action_ = context_.actions.add({.id = "mapProperties",
                                      .text = tr("P&roperties of the map"),
                                      .icon = "map",
                                      .tip = tr("Name, size, resolution, origin and cells of the whole map"),
                                      .menu = {MenuGroup::WholeMap, 90}},
                                     this, &ObjectsController::showMap);
  context_.actions.add({.id = "findObject",
                        .text = tr("Find an &object…"),
                        .icon = "search",
                        .keys = {"Ctrl+Shift+F"},
                        .tip = tr("Search everything that the visible layers show"),
                        .needs_session = true,
                        .menu = {MenuGroup::Window, 15}},
                       this, [this] {
                         context_.panels.open(dock_);
                         dock_->filterEdit()->setFocus();
                         dock_->filterEdit()->selectAll();
                       });
}

void ObjectsController::allowMap() {
  const session::Session* const session = context_.current.session();
  allow(map_action_, session && session->wholeMap().cells(), tr("There is no whole map on screen."));
}

void ObjectsController::showMap() {
  const scene::ObjectId id{scene::Layer::WholeMap, scene::FeaturesOf::WholeMap, {}, 0};
  context_.panels.open(properties_);
  const auto map = context_.scene.object(id);
  if (!map) {
    letGo();
    context_.overlay.toasts()->add(Mark::Neutral, tr("There is no whole map on screen."));
    return;
  }
  choose(id, map->at_m, 0);
  card_->hide();
}

void ObjectsController::addToMapMenu() {
  context_.actions.addToMapMenu({MapMenuGroup::Point, 5}, [this](QMenu& menu, const Eigen::Vector2d& world) {
    const std::vector<scene::ObjectId> ids = context_.scene.objectsAt(world, MapTool::kReachPx);
    int shown = 0;
    for (const scene::ObjectId& id : ids) {
      const auto object = context_.scene.object(id);
      if (!object) continue;
      if (++shown > kMostInMenu) {
        const qint64 more = qint64(ids.size()) - kMostInMenu;
        menu
            .addAction(sentences::counted(
                ObjectCard::tr("%1 other things here: Alt+click", nullptr, sentences::formOf(more)), more))
            ->setEnabled(false);
        break;
      }
      QString text = calledInFull(*object);
      menu.addAction(QIcon(sharedPixmap(context_.scene.symbolOf(*object, 16, qApp->devicePixelRatio()))),
                     text.replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                     [this, id, world] { choose(id, world, 0); });
    }
  });
}

void ObjectsController::addFindings() {
  context_.findings.add([this]() -> Findings::Search {
    if (!context_.current.session()) return [](const QString&, const Findings::See&) {};
    auto all = std::make_shared<std::vector<scene::MapObject>>(context_.scene.objects(kMostListed));
    return [this, all](const QString&, const Findings::See& see) {
      for (const scene::MapObject& object : *all) {
        see({calledInFull(object), scene::layerTitle(object.id.layer), QStringLiteral("locate"),
             [this, id = object.id] { locate(id); }});
      }
    };
  });
}

void ObjectsController::setSession(session::Session* session) {
  letGo();
  hover_timer_.stop();
  list_timer_.stop();
  if (session) {
    connect(session, &session::Session::liveChanged, this, [this](int what) {
      if (chosen_ && chosen_->topic == what) refreshSoon();
      if (dock_->isVisible() && !list_timer_.isActive()) list_timer_.start();
    });
    for (const session::MapSlot* slot : {&session->wholeMap(), &session->comparedMap()})
      connect(slot, &session::MapSlot::changed, this, &ObjectsController::refreshSoon);
  }
  list();
}

ObjectsController::~ObjectsController() {
  if (count_cancelled_) *count_cancelled_ = true;
}

std::vector<scene::ObjectProperty> ObjectsController::facts(const scene::MapObject& object) const {
  const session::Session* const session = context_.current.session();
  if (!session) return {};
  const bool whole = object.id.layer == scene::Layer::WholeMap;
  return factsOf(object, *session, wall_(), whole ? counts_ : std::nullopt);
}

void ObjectsController::count() {
  const session::Session* const session = context_.current.session();
  if (!session || !chosen_ || chosen_->id.layer != scene::Layer::WholeMap || !properties_->isVisible())
    return;
  const bool compared = chosen_->id.of == scene::FeaturesOf::ComparedMap;
  const auto cells = (compared ? session->comparedMap() : session->wholeMap()).cells();
  if (!cells || cells == counted_ || !cells->complete()) return;
  if (count_cancelled_) *count_cancelled_ = true;
  counted_ = cells;
  counts_.reset();
  count_cancelled_ = std::make_shared<std::atomic<bool>>(false);
  tasks_.startLong([this, cells, cancelled = count_cancelled_] {
    const auto counts = grids::countCells(*cells, *cancelled);
    if (!counts) return;
    QMetaObject::invokeMethod(
        this,
        [this, cells, counts] {
          if (cells != counted_) return;
          counts_ = counts;
          refreshSoon();
        },
        Qt::QueuedConnection);
  });
}

bool ObjectsController::escape() {
  if (!chosen_) return false;
  letGo();
  return true;
}

void ObjectsController::clickedOnMap(const MapPoint& at) {
  pick(at.world_m, at.modifiers.testFlag(Qt::AltModifier));
}

void ObjectsController::identify() {
  const Eigen::Vector2d at = context_.view.cursorWorld().value_or(context_.scene.view().center_m);
  const bool again = picked_px_ && chosen_ && near(*picked_px_, toPixel(context_.scene, at), kSamePx);
  pick(at, again);
}

void ObjectsController::pick(const Eigen::Vector2d& world_m, bool beneath) {
  if (!context_.current.session()) return;
  const QPointF px = toPixel(context_.scene, world_m);
  const bool same_position = picked_px_ && near(*picked_px_, px, kSamePx);
  hover_timer_.stop();  // it has been told
  here_ = context_.scene.objectsAt(world_m, MapTool::kReachPx);
  turn_ = beneath && same_position ? turn_ + 1 : beneath ? 1 : 0;
  picked_px_ = px;
  if (here_.empty()) return letGo();
  turn_ %= here_.size();
  // The ground is everywhere: a second click on it is how to be rid of it.
  const scene::ObjectId& id = here_[turn_];
  const bool ground = id.layer == scene::Layer::Submaps || id.layer == scene::Layer::WholeMap;
  if (ground && !beneath && chosen_ && chosen_->id.sameAs(id)) return letGo();
  choose(here_[turn_], world_m, int(here_.size()) - 1);
}

void ObjectsController::choose(const scene::ObjectId& id, const Eigen::Vector2d& card_at_m, int beneath) {
  chosen_ = context_.scene.object(id);
  if (!chosen_) return letGo();
  context_.scene.setMarked(chosen_);
  showCard(*chosen_, card_at_m, beneath, true);
  dock_->point(id);
  refresh();
  if (chosen_) Q_EMIT chose(scene::MapObject(*chosen_));
}

void ObjectsController::locate(const scene::ObjectId& id) {
  const auto object = context_.scene.object(id);
  if (!object) {
    context_.overlay.toasts()->add(Mark::Neutral, tr("It is no longer on the map."));
    return list();
  }
  context_.viewpoint.lookAt(object->bounds().grown(kRoomAroundM));
  choose(id, object->at_m, 0);
}

void ObjectsController::wentTo(map::SubmapId submap) {
  if (chosen_ && scene::submapOf(chosen_->id) != submap) letGo();
}

void ObjectsController::letGo() {
  chosen_.reset();
  if (count_cancelled_) *count_cancelled_ = true;
  counted_.reset();
  counts_.reset();
  here_.clear();
  picked_px_.reset();
  hovered_px_.reset();
  age_timer_.stop();
  refresh_timer_.stop();
  card_->setStaying(false);
  card_->hide();
  context_.scene.setMarked(std::nullopt);
  properties_->clear();
  dock_->point(std::nullopt);
}

void ObjectsController::cursorMoved() {
  const auto world = context_.view.cursorWorld();
  if (hovered_px_) {
    const bool rests = world && near(*hovered_px_, toPixel(context_.scene, *world), MapTool::kReachPx / 2);
    if (rests) return;
    hovered_px_.reset();
    hovered_.reset();
    if (!chosen_) age_timer_.stop();
    // What was chosen is told again.
    if (chosen_) {
      showCard(*chosen_, card_at_m_, card_beneath_, true);
    } else {
      card_->hide();
    }
  }
  const bool asks =
      world && context_.current.session() && context_.view.activeTool()->name() == QLatin1String("pan");
  asks ? hover_timer_.start() : hover_timer_.stop();
}

void ObjectsController::hover() {
  const auto world = context_.view.cursorWorld();
  if (!world || context_.view.moving()) return;
  const std::vector<scene::ObjectId> ids = context_.scene.objectsAt(*world, MapTool::kReachPx);
  if (ids.empty()) return;
  // Submaps are everywhere: they are told when they are asked for, or drawn one by one.
  const bool outlined =
      context_.scene.layerVisible(scene::Layer::Outlines) || context_.scene.layerVisible(scene::Layer::Ids);
  const bool ground =
      ids.front().layer == scene::Layer::Submaps || ids.front().layer == scene::Layer::WholeMap;
  if (ground && !(outlined && ids.front().layer == scene::Layer::Submaps)) return;
  if (chosen_ && ids.front().sameAs(chosen_->id)) return;
  const auto object = context_.scene.object(ids.front());
  if (!object) return;
  hovered_px_ = toPixel(context_.scene, *world);
  hovered_ = object;
  hovered_beneath_ = int(ids.size()) - 1;
  if (object->topic >= 0) age_timer_.start();
  const Eigen::Vector2d kept = card_at_m_;
  const int kept_beneath = card_beneath_;
  showCard(*object, *world, int(ids.size()) - 1, false);
  card_at_m_ = kept;
  card_beneath_ = kept_beneath;
}

void ObjectsController::showCard(const scene::MapObject& object, const Eigen::Vector2d& at_m, int beneath,
                                 bool stays) {
  const session::Session* const session = context_.current.session();
  if (!session) return;
  card_->setStaying(stays);
  card_->show(object, facts(object), beneath);
  card_at_m_ = at_m;
  card_beneath_ = beneath;
  positionCard();
}

void ObjectsController::positionCard() {
  if (card_->isHidden()) return;
  constexpr double kGapPx = 16;
  constexpr int kMarginPx = 8, kLargestPx = 160;
  const QPointF at = hovered_px_ ? *hovered_px_ : toPixel(context_.scene, card_at_m_);
  const QRect map = context_.view.viewport()->rect();
  const QRect room =
      map.adjusted(kMarginPx, int(context_.scene.coveredTop()) + kMarginPx, -kMarginPx, -kMarginPx);
  // With what has left the map its card is gone; so it is with what was gone away from.
  card_->setEnabled(QRectF(map).contains(at));
  if (!card_->isEnabled()) return card_->move(map.bottomRight() + QPoint(1, 1));
  QRectF clear = QRectF(at, QSizeF()).adjusted(-kGapPx, -kGapPx, kGapPx, kGapPx);
  if (const auto& about = hovered_px_ ? hovered_ : chosen_) {
    const geometry::WorldRect bounds = about->bounds();
    QRectF all(toPixel(context_.scene, {bounds.min_x, bounds.min_y}), QSizeF());
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(bounds.max_x, bounds.min_y), Eigen::Vector2d(bounds.max_x, bounds.max_y),
          Eigen::Vector2d(bounds.min_x, bounds.max_y)})
      all |= QRectF(toPixel(context_.scene, corner), QSizeF(0.1, 0.1));
    all.adjust(-kGapPx, -kGapPx, kGapPx, kGapPx);
    if (std::max(all.width(), all.height()) <= kLargestPx && all.intersects(clear)) clear |= all;
  }
  // Where it does not fit beside the thing, it says less.
  for (int rows = card_->allRows();; --rows) {
    card_->showRows(rows);
    const auto corner = positionBeside(clear.toAlignedRect(), card_->size(), room);
    if (corner) return card_->move(*corner);
    if (rows == 0) break;
  }
  card_->move(at.x() < room.center().x() ? room.right() - card_->width() : room.left(),
              at.y() < room.center().y() ? room.bottom() - card_->height() : room.top());
}

void ObjectsController::refreshSoon() {
  if (chosen_ && !refresh_timer_.isActive()) refresh_timer_.start();
  if (dock_->isVisible() && !list_timer_.isActive()) list_timer_.start();
}

void ObjectsController::refresh() {
  const session::Session* const session = context_.current.session();
  if (session && hovered_px_ && hovered_) {
    const auto now = context_.scene.object(hovered_->id);
    if (now) hovered_ = now;
    card_->show(*hovered_, facts(*hovered_), hovered_beneath_);
    positionCard();
  }
  if (!chosen_ || !session) {
    if (!hovered_px_) age_timer_.stop();
    return;
  }
  const auto now = context_.scene.object(chosen_->id);
  if (now) {
    chosen_ = now;
    context_.scene.setMarked(now);
  } else {
    context_.scene.setMarked(std::nullopt);
  }
  count();
  const std::vector<scene::ObjectProperty> known = facts(*chosen_);
  if (properties_->isVisible()) properties_->setObject(*chosen_, known, !now);
  if (!now && !hovered_px_) card_->hide();
  if (now && !hovered_px_ && card_->isVisible()) {
    card_->show(*chosen_, known, card_beneath_);
    positionCard();
  }
  // Ages grow; what is not looked at needs no clock.
  const bool looked_at = chosen_->topic >= 0 && (card_->isVisible() || properties_->isVisible());
  if (!looked_at && !hovered_px_) {
    age_timer_.stop();
  } else if (!age_timer_.isActive()) {
    age_timer_.start();
  }
}

void ObjectsController::list() {
  if (!dock_->isVisible()) return;
  QElapsedTimer took;
  took.start();
  std::vector<scene::MapObject> all;
  if (context_.current.session()) all = context_.scene.objects(kMostListed + 1);
  const bool more = all.size() > kMostListed;
  if (more) all.pop_back();
  dock_->setObjects(std::move(all), more);
  dock_->point(chosen_ ? std::optional(chosen_->id) : std::nullopt);
  // The longer the list, the less often it is made: a fiftieth of the time.
  constexpr qint64 kTimesAsLong = 50;
  list_timer_.setInterval(int(std::max<qint64>(kListMs, took.elapsed() * kTimesAsLong)));
}

void ObjectsController::copyChosen() {
  const session::Session* const session = context_.current.session();
  if (!session || !chosen_) return;
  copyText(context_.overlay, asText(*chosen_, facts(*chosen_)), tr("Properties copied"));
}

}  // namespace mapwright::ui

#include "moc_objects_controller.cpp"
