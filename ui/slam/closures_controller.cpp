#include "ui/slam/closures_controller.h"

#include <algorithm>
#include <utility>

#include "map/live_state.h"
#include "robot/robot.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/plural.h"
#include "session/session.h"
#include "ui/kit/panels.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/viewpoint.h"
#include "ui/slam/closures_dock.h"
#include "ui/view/map_view.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

// Of what is seen around both places: in proportion to their distance, but never so little that nothing of
// the map is recognised.
constexpr double kAroundShare = 1.5, kAroundLeastM = 0.15, kAroundMostM = 2;
constexpr double kClosestMPerPx = 0.0005;

ClosureRow rowOf(const map::Closure& one) {
  return {one.residual_m, one.residual_rad, one.submap, one.node,
          one.kind,       one.stamp_s,      one.at,     one.expected};
}

std::vector<ClosureRow> rowsOf(const map::Closures& closures) {
  std::vector<ClosureRow> rows;
  rows.reserve(closures.ranked.size());
  for (const map::Closure& one : closures.ranked) rows.push_back(rowOf(one));
  return rows;
}

/// A mapping robot names its lists: those of residuals are lines from where something is to where it should
/// be.
std::vector<ClosureRow> rowsOf(const map::ConstraintsMessage& lists) {
  std::vector<ClosureRow> rows;
  for (const auto& [name, segments] : lists.by_name) {
    if (name.find("esidual") == std::string::npos) continue;
    const bool intra = name.find("ntra") != std::string::npos;
    for (const auto& [from, to] : segments)
      rows.push_back({.residual_m = (to - from).norm(),
                      .kind = intra ? map::ConstraintKind::Intra : map::ConstraintKind::Inter,
                      .at = from,
                      .expected = to});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const ClosureRow& a, const ClosureRow& b) { return a.residual_m > b.residual_m; });
  return rows;
}

}  // namespace

ClosuresController::ClosuresController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), dock_(new ClosuresDock(&context.window)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 21, .menu_rank = 31});
  connect(dock_, &ClosuresDock::shown, this, &ClosuresController::want);
  connect(dock_, &ClosuresDock::chosen, this, &ClosuresController::show);
  connect(dock_, &ClosuresDock::onMapWanted, this,
          [this](bool shown) { context_.scene.setLayerVisible(layer(), shown); });
  connect(dock_, &ClosuresDock::filtered, this, &ClosuresController::follow);
  connect(dock_, &QDockWidget::visibilityChanged, this, [this] {
    want();
    follow();
  });
  connect(&context_.scene, &scene::MapScene::layersChanged, this, &ClosuresController::showOnMap);
  showOnMap();
}

void ClosuresController::showOnMap() {
  dock_->setOnMap(context_.scene.layerVisible(layer()), layer() == scene::Layer::Closures);
}

void ClosuresController::follow() {
  const auto all = session_ ? session_->poseGraph().closures() : nullptr;
  const ClosureFilter& filter = dock_->model()->filter();
  // Behind another tab it is open, too.
  if (!all || dock_->isHidden() || filter.listsLoopClosures()) return context_.scene.setClosures(nullptr);
  const auto listed = std::make_shared<map::Closures>();
  for (const map::Closure& one : all->ranked) {
    if (filter.lists(rowOf(one))) listed->ranked.push_back(one);
  }
  context_.scene.setClosures(listed);
}

void ClosuresController::setSession(session::Session* session) {
  if (session_) {
    session_->disconnect(this);
    session_->poseGraph().disconnect(this);
  }
  session_ = session;
  marked_ = false;
  dock_->listAllSubmaps();
  dock_->hidePlaces();
  if (session_) {
    connect(&session_->poseGraph(), &session::PoseGraphSlot::changed, this, &ClosuresController::refresh);
    connect(session_, &session::Session::connectionChanged, this, &ClosuresController::refresh);
    connect(session_, &session::Session::liveChanged, this, [this](int what) {
      if (what == map::topicIndex<map::ConstraintsMessage>()) refresh();
    });
  }
  want();
  refresh();
}

scene::Layer ClosuresController::layer() const {
  return session_ && !session_->poseGraph().offered() ? scene::Layer::Constraints : scene::Layer::Closures;
}

void ClosuresController::want() {
  if (!session_) return;
  const bool open = dock_->isVisible();
  if (open) session_->poseGraph().want();
  session_->want(QStringLiteral("closures"), open ? map::Streams{map::Stream::Constraints} : map::Streams{});
  if (open) refresh();
}

void ClosuresController::refresh() {
  follow();
  if (!dock_->isVisible() && session_) return;
  dock_->setSummary(summary());
  showOnMap();
  if (!session_) return dock_->setRows({});
  const auto& closures = session_->poseGraph().closures();
  dock_->setRows(closures ? rowsOf(*closures) : rowsOf(session_->live().constraints));
}

QString ClosuresController::summary() const {
  if (!session_) return tr("Connect to a robot or open a file to see its loop closures.");
  const session::PoseGraphSlot& graph = session_->poseGraph();
  if (!graph.closures()) {
    if (graph.loading()) return tr("The pose graph is being read.");
    if (graph.failure())
      return tr("The pose graph was not read. %1")
          .arg(QString::fromStdString(sentences::failureReason(*graph.failure())))
          .trimmed();
    if (graph.offered()) return {};
    if (!session_->live().constraints.by_name.empty())
      return tr(
          "The residuals that the robot reports while it maps. It does not say which submaps and nodes "
          "they tie together.");
    return sentences::absenceReason(robot::Capability::PoseGraph,
                                    session_->robot().unavailableReason(robot::Capability::PoseGraph));
  }
  const map::Closures& closures = *graph.closures();
  QStringList said;
  if (closures.inter == 0) {
    said << tr("No loop was closed: this map is odometry and scan matching only.");
  } else {
    const auto bad =
        qint64(std::count_if(closures.ranked.begin(), closures.ranked.end(), [](const map::Closure& closure) {
          return closure.kind == map::ConstraintKind::Inter && closure.residual_m > kContradictsMapM;
        }));
    said << sentences::counted(tr("%1 loop closures.", nullptr, sentences::formOf(qint64(closures.inter))),
                               qint64(closures.inter));
    said << (bad == 0 ? tr("None contradicts the finished map by more than 0.5 m.")
                      : sentences::counted(tr("%1 contradict the finished map by more than 0.5 m.", nullptr,
                                              sentences::formOf(bad)),
                                           bad));
  }
  if (closures.dangling > 0)
    said << sentences::counted(tr("%1 are not listed: their submap or node is not there.", nullptr,
                                  sentences::formOf(qint64(closures.dangling))),
                               qint64(closures.dangling));
  if (closures.without_pose > 0)
    said << sentences::counted(tr("%1 are not listed: they have no valid pose.", nullptr,
                                  sentences::formOf(qint64(closures.without_pose))),
                               qint64(closures.without_pose));
  return words::paragraph(said);
}

void ClosuresController::show(const ClosureRow& row) {
  if (!session_) return;
  geometry::WorldRect around;
  around.extend(row.at);
  around.extend(row.expected);
  const double apart_m = (row.expected - row.at).norm();
  around = around.grown(std::clamp(kAroundShare * apart_m, kAroundLeastM, kAroundMostM));
  context_.viewpoint.choose();
  context_.view.fit(around, true, kClosestMPerPx);
  scene::MapObject object;
  object.id.layer = scene::Layer::Closures;
  object.form = scene::ObjectForm::Line;
  object.at_m = (row.at + row.expected) / 2;
  object.parts = {{row.at, row.expected}};
  context_.scene.setMarked(std::move(object));
  say(row);
}

void ClosuresController::say(const ClosureRow& row) {
  dock_->setPlaces(row.at, row.expected);
  if (row.submap) Q_EMIT submapShown(*row.submap);
  marked_ = true;
}

void ClosuresController::chosenOnMap(const scene::MapObject& object) {
  const bool is_closure = object.id.layer == scene::Layer::Closures && object.parts.size() == 1 &&
                          object.parts.front().size() == 2;
  if (!is_closure || dock_->isHidden()) return;
  context_.panels.open(dock_);
  const std::vector<ClosureRow>& all = dock_->model()->all();
  const auto row = std::find_if(all.begin(), all.end(), [&](const ClosureRow& one) {
    return one.submap && one.node &&
           map::toText(*one.submap) + ':' + map::toText(*one.node) == object.id.key &&
           one.at == object.parts.front().front() && one.expected == object.parts.front().back();
  });
  if (row == all.end()) return;
  dock_->point(*row);
  say(*row);
}

bool ClosuresController::escape() {
  if (!std::exchange(marked_, false)) return false;
  dock_->hidePlaces();
  context_.scene.setMarked(std::nullopt);
  return true;
}

}  // namespace mapwright::ui

#include "moc_closures_controller.cpp"
