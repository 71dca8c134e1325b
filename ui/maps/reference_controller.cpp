#include "ui/maps/reference_controller.h"

#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QCryptographicHash>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QPushButton>
#include <QUndoCommand>

#include "align/alignment_sentence.h"
#include "map/live_state.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/kit/status_text.h"
#include "ui/kit/undo_stacks.h"
#include "ui/maps/align_on_screen.h"
#include "ui/maps/reference_dock.h"
#include "ui/maps/reference_tool.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {

constexpr std::size_t kMostPairs = 200;

/// The address of a map that the robot itself has: it is not remembered, but where it lay is.
const QString kOfRobot = QStringLiteral("robot:");

QString keyOf(const QString& current_map) {
  const QByteArray digest =
      QCryptographicHash::hash(current_map.toUtf8(), QCryptographicHash::Sha256).toHex().left(32);
  return QStringLiteral("reference/") + QString::fromLatin1(digest);
}

QJsonArray numbers(std::initializer_list<double> values) {
  QJsonArray array;
  for (const double value : values) array << value;
  return array;
}

std::optional<placing::PointPair> pairFrom(const QJsonArray& array) {
  if (array.size() != 4) return std::nullopt;
  const placing::PointPair pair{{array[0].toDouble(NAN), array[1].toDouble(NAN)},
                                {array[2].toDouble(NAN), array[3].toDouble(NAN)}};
  const bool sound = pair.on_map_m.allFinite() && pair.in_world_m.allFinite();
  return sound ? std::optional(pair) : std::nullopt;
}

}  // namespace

class ReferenceController::Step : public QUndoCommand {
 public:
  Step(ReferenceController& reference, const QString& what, Laid after, int drag)
      : QUndoCommand(what),
        reference_(reference),
        before_(reference.laid_),
        after_(std::move(after)),
        drag_(drag) {}
  void undo() override { reference_.setLaid(before_); }
  void redo() override { reference_.setLaid(after_); }
  int id() const override { return drag_ > 0 ? drag_ : -1; }
  bool mergeWith(const QUndoCommand* later) override {
    after_ = static_cast<const Step*>(later)->after_;
    setObsolete(before_ == after_);
    return true;
  }

 private:
  ReferenceController& reference_;
  Laid before_, after_;
  int drag_;
};

ReferenceController::ReferenceController(WindowContext& context, PicturePlacing& placing, Read read,
                                         QObject* parent)
    : Controller(parent),
      context_(context),
      placing_(placing),
      read_(std::move(read)),
      dock_(new ReferenceDock(&context.window)),
      tool_(new ReferenceTool(&context.scene, this)),
      slot_({}, {context.workers, nullptr}),
      walls_off_(&context.scene, context.workers),
      run_(context.workers) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 70, .menu_rank = 36, .open = false});
  context_.actions.add({.id = "referenceMap",
                        .text = tr("Re&ference map…"),
                        .icon = "layers",
                        .tip = tr("Lay a map file under what the robot shows"),
                        .needs_session = true,
                        .menu = {MenuGroup::WholeMap, 20}},
                       this, [this] {
                         context_.panels.open(dock_);
                         if (address_.isEmpty()) choose(false);
                       });
  context_.actions.add({.id = "alignMap",
                        .text = tr("&Align with another map…"),
                        .icon = "layers",
                        .tip = tr("Find out where another map lies on the one on screen, and lay it there"),
                        .needs_session = true,
                        .menu = {MenuGroup::WholeMap, 25}},
                       this, [this] {
                         context_.panels.open(dock_);
                         choose(true);
                       });
  tool_action_ = context_.actions.add({.id = "referenceTool",
                                       .text = tr("Move the refere&nce map"),
                                       .tip = tr("Drag or turn the reference map, or add pairs of points"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Waypoints, 90}});
  tool_action_->setEnabled(false);
  context_.tools.add(tool_, tool_action_);
  connect(tool_action_, &QAction::toggled, this, [this](bool on) {
    context_.scene.setReferenceAbove(on);
    if (!on) dock_->setTool(false, false);
    if (on && !dock_->pairsButton()->isChecked()) dock_->setTool(true, false);
  });
  connect(tool_, &MapTool::finished, this, [this] { useTool(false, false); });
  joinUndo(context_.undo, steps_);
  connect(&context_.undo, &QUndoGroup::activeStackChanged, this, [this](QUndoStack* stack) {
    if (stack != &steps_) other_steps_ = stack;
  });
  connect(tool_, &ReferenceTool::refused, this,
          [this](const QString& why) { context_.overlay.toasts()->add(Mark::Warning, why); });
  connect(tool_, &ReferenceTool::taken, this, [this] { ++drag_; });
  connect(tool_, &ReferenceTool::moved, this, [this](const geometry::Pose2& pose) {
    change(tr("move the reference map"), {pose, laid_.pairs}, drag_);
  });
  connect(tool_, &ReferenceTool::paired, this, [this](const placing::PointPair& pair) {
    std::vector<placing::PointPair> pairs = laid_.pairs;
    pairs.push_back(pair);
    setPairs(tr("add a pair of points"), std::move(pairs));
  });
  connect(dock_, &ReferenceDock::chooseWanted, this, [this] { choose(false); });
  connect(dock_, &ReferenceDock::removeWanted, this, &ReferenceController::removeMap);
  connect(dock_, &ReferenceDock::moveWanted, this, [this](bool on) { useTool(on, false); });
  connect(dock_, &ReferenceDock::pairsWanted, this, [this](bool on) { useTool(on, true); });
  connect(dock_, &ReferenceDock::typed, this, [this](const geometry::Pose2& pose) {
    change(tr("move the reference map"), {pose, laid_.pairs});
  });
  connect(dock_, &ReferenceDock::fitWanted, this,
          [this] { setPairs(tr("fit the reference map"), laid_.pairs); });
  connect(dock_, &ReferenceDock::pairsUnwanted, this,
          [this] { setPairs(tr("remove all pairs of points"), {}); });
  connect(dock_, &ReferenceDock::pairUnwanted, this, [this](int index) {
    std::vector<placing::PointPair> pairs = laid_.pairs;
    if (index < 0 || std::size_t(index) >= pairs.size()) return;
    pairs.erase(pairs.begin() + index);
    setPairs(tr("remove a pair of points"), std::move(pairs));
  });
  connect(dock_, &ReferenceDock::alignWanted, this, &ReferenceController::align);
  connect(dock_, &ReferenceDock::alignCancelled, this, &ReferenceController::forgetAlignment);
  connect(dock_, &ReferenceDock::candidateWanted, this, &ReferenceController::layCandidate);
  connect(dock_, &ReferenceDock::placeWanted, this, [this](const Eigen::Vector2d& at) {
    constexpr double kAround_m = 3;
    context_.scene.setMarker(at);
    context_.viewpoint.lookAt(
        {at.x() - kAround_m, at.y() - kAround_m, at.x() + kAround_m, at.y() + kAround_m});
  });
  connect(dock_, &ReferenceDock::differencesWanted, this, &ReferenceController::syncDifferences);
  connect(dock_->wallsOffBox(), &QCheckBox::toggled, this,
          [this](bool on) { context_.scene.setLayerVisible(scene::Layer::WallsOff, on); });
  connect(&context_.scene, &scene::MapScene::layersChanged, this, [this] {
    const QSignalBlocker quiet(dock_->wallsOffBox());
    dock_->wallsOffBox()->setChecked(context_.scene.layerVisible(scene::Layer::WallsOff));
    syncDifferences();
  });
  connect(dock_, &ReferenceDock::swipeWanted, this, [this] {
    map::WholeMap map = read_map_;
    map.grid.origin = laid_.pose * map.grid.origin;
    Q_EMIT swipeWanted(map);
  });
  connect(&walls_off_, &WallsOffMarks::found, this,
          [this] { dock_->setWallsOff(walls_off_.shown()->walls.empty()); });
  connect(&slot_, &session::MapSlot::changed, this, &ReferenceController::show);
  connect(&slot_, &session::MapSlot::rowsArrived, this, [this] { context_.scene.referenceRowsArrived(); });
}

ReferenceController::~ReferenceController() { slot_.disconnect(this); }

void ReferenceController::setSession(session::Session* session) {
  load({});
  current_map_.clear();
  if (!session) return;
  connect(session, &session::Session::liveChanged, this, [this](int what) {
    if (what == map::topicIndex<map::MapInfo>()) onCurrentMapChanged();
  });
  connect(&session->wholeMap(), &session::MapSlot::changed, this, [this] {
    onCurrentMapChanged();
    checkAlignment();
    syncDifferences();
  });
  using session::Session;
  connect(session, &Session::listChanged, this, &ReferenceController::onSubmapsChanged);
  connect(session, &Session::submapsPlaced, this, &ReferenceController::onSubmapsChanged);
  connect(session, &Session::submapsRemoved, this, &ReferenceController::onSubmapsChanged);
  connect(session, &Session::sessionRestarted, this, [this] {
    if (aligned_ && !aligned_->map) forgetAlignment();
  });
  onCurrentMapChanged();
}

QString ReferenceController::currentMap() const {
  const session::Session* const session = context_.current.session();
  if (!session) return {};
  QString map;
  if (const auto& info = session->live().map_info) {
    map = QString::fromStdString(info->uid.empty() ? info->name : info->uid);
  } else if (session->wholeMap().cells()) {
    map = QString::fromStdString(map::toText(session->wholeMap().shown().key));
  }
  return QStringLiteral("%1\n%2").arg(session->robot().address(), map);
}

void ReferenceController::onCurrentMapChanged() {
  const QString now = currentMap();
  if (now == current_map_) return;
  current_map_ = now;
  const QString address = kept().value(QLatin1String("map")).toString();
  // What was laid before it was known where the robot is stays, unless something is remembered for here.
  if (address.isEmpty() && !address_.isEmpty()) return rememberForMap();
  onLaid(kept().value(QLatin1String("laid")).toObject().value(address).toObject());
  load(address);
}

void ReferenceController::rememberForMap() {
  if (current_map_.isEmpty()) return;
  QJsonObject all = kept();
  // How each map lay, so that it lies there again when it is chosen again.
  QJsonObject laid = all.value(QLatin1String("laid")).toObject();
  if (!address_.isEmpty()) {
    QJsonArray pairs;
    for (const placing::PointPair& pair : laid_.pairs)
      pairs << numbers({pair.on_map_m.x(), pair.on_map_m.y(), pair.in_world_m.x(), pair.in_world_m.y()});
    laid[address_] =
        QJsonObject{{QStringLiteral("pose"), numbers({laid_.pose.x_m, laid_.pose.y_m, laid_.pose.yaw_rad})},
                    {QStringLiteral("pairs"), pairs}};
  }
  all[QStringLiteral("map")] = address_.startsWith(kOfRobot) ? QString() : address_;
  all[QStringLiteral("laid")] = laid;
  context_.settings.setValue(keyOf(current_map_),
                             QString::fromUtf8(QJsonDocument(all).toJson(QJsonDocument::Compact)));
}

void ReferenceController::choose(bool align) {
  const QString path = QFileDialog::getOpenFileName(
      &context_.window, align ? tr("Choose the map to align with") : tr("Choose a reference map"),
      lastMapFolder(context_.settings), tr("Maps (*.yaml *.yml *.png *.pgm *.bmp)"));
  if (path.isEmpty()) return;
  rememberMapFolder(context_.settings, QFileInfo(path).absolutePath());
  if (isBarePicture(path)) {
    placing_.place(path, align ? tr("Align") : tr("Lay it"),
                   [this, align](const QString& address) { lay(address, align); });
  } else {
    lay(fileAddress(path), align);
  }
}

void ReferenceController::lay(const QString& address, bool align) {
  if (address == address_) {
    if (align) this->align();
    return;
  }
  // What is laid stays until another map is there.
  auto source = sourceOf(address);
  if (!source) return context_.overlay.toasts()->add(Mark::Bad, source.error());
  stopFetching();
  coming_ = std::move(source->reader);
  if (coming_) coming_->connectToRobot();
  if (align) {
    forgetAlignment();
    fetching_ = true;
    dock_->setProgress(0);
    showAlignment();
  }
  coming_call_ = source->maps->fetch(
      source->key, [this, address, align, number = ++coming_number_](robot::Outcome<map::WholeMap> answer) {
        if (number != coming_number_) return;
        fetching_ = false;
        if (!answer) {
          if (!align) return showFailure(answer.error());
          return say(tr("The map to align with could not be fetched. %1")
                         .arg(QString::fromStdString(sentences::failureReason(answer.error()))));
        }
        onLaid(kept().value(QLatin1String("laid")).toObject().value(address).toObject());
        address_ = address;
        reader_ = std::move(coming_);
        slot_.clear();
        showRead(std::move(*answer));
        rememberForMap();
        if (align) this->align();
      });
  coming_call_.onProgress([this, number = coming_number_](robot::Progress progress) {
    if (number == coming_number_ && fetching_ && progress.of_bytes.value_or(0) > 0)
      dock_->setProgress(double(progress.bytes) / double(*progress.of_bytes));
  });
}

void ReferenceController::stopFetching() {
  if (!std::exchange(fetching_, false)) return;
  ++coming_number_;
  coming_call_.cancel();
  coming_.reset();
}

void ReferenceController::alignWithMap(const map::MapKey& key) {
  context_.panels.open(dock_);
  lay(kOfRobot + QString::fromStdString(map::toText(key)), true);
}

tl::expected<ReferenceController::Source, QString> ReferenceController::sourceOf(const QString& address) {
  const QString none = tr("This is not a map file.");
  if (address.startsWith(kOfRobot)) {
    session::Session* const session = context_.current.session();
    robot::WholeMapSource* const maps = session ? session->robot().wholeMapSource() : nullptr;
    if (!maps) return tl::make_unexpected(none);
    return Source{nullptr, maps, map::mapKeyFromText(address.mid(kOfRobot.size()).toStdString())};
  }
  auto reader = read_(address);
  if (!reader) return tl::make_unexpected(reader.error());
  robot::WholeMapSource* const maps = *reader ? (*reader)->wholeMapSource() : nullptr;
  if (!maps) return tl::make_unexpected(none);
  return Source{std::move(*reader), maps, {map::MapKind::File, {}}};
}

void ReferenceController::showFailure(const map::Failure& failure) {
  const QString sentence = QString::fromStdString(sentences::sentenceOf(failure));
  context_.overlay.toasts()->add(Mark::Bad, tr("The reference map: %1").arg(sentence));
}

QJsonObject ReferenceController::kept() const {
  return QJsonDocument::fromJson(context_.settings.value(keyOf(current_map_)).toString().toUtf8()).object();
}

void ReferenceController::onLaid(const QJsonObject& laid) {
  const QJsonArray pose = laid.value(QLatin1String("pose")).toArray();
  laid_ = {};
  forgetSteps();
  forgetAlignment();
  if (pose.size() == 3) laid_.pose = {pose[0].toDouble(), pose[1].toDouble(), pose[2].toDouble()};
  for (const QJsonValue& each : laid.value(QLatin1String("pairs")).toArray()) {
    const auto pair = pairFrom(each.toArray());
    if (pair && laid_.pairs.size() < kMostPairs) laid_.pairs.push_back(*pair);
  }
}

void ReferenceController::removeMap() {
  load({});
  rememberForMap();
}

void ReferenceController::load(const QString& address) {
  forgetSteps();
  forgetAlignment();
  ++coming_number_;
  address_ = address;
  reader_.reset();
  coming_.reset();
  slot_.clear();
  read_map_ = {};
  if (address.isEmpty()) {
    useTool(false, false);
    return show();
  }
  auto source = sourceOf(address);
  if (!source) {
    context_.overlay.toasts()->add(Mark::Bad, source.error());
    address_.clear();
    return show();
  }
  reader_ = std::move(source->reader);
  if (reader_) reader_->connectToRobot();
  slot_.expect(source->key, {});
  source->maps->fetch(source->key,
                      [this, address, number = coming_number_](robot::Outcome<map::WholeMap> answer) {
                        if (number != coming_number_ || address != address_) return;
                        if (answer) return showRead(std::move(*answer));
                        showFailure(answer.error());
                        slot_.clear();
                        // It stays remembered: a folder that is away today may be there tomorrow.
                        address_.clear();
                        show();
                      });
  show();
}

void ReferenceController::showRead(map::WholeMap map) {
  read_map_ = map;
  // Its cells only: what lies on it would have to be moved, too.
  read_map_.trajectories.clear();
  read_map_.overlays.clear();
  read_map_.broken_overlays.clear();
  read_map_.landmarks.clear();
  slot_.show(std::move(map));
}

void ReferenceController::show() {
  const bool there = slot_.cells() != nullptr;
  std::optional<render::PlacedGrid> placed;
  if (there) {
    placed = render::PlacedGrid{slot_.cells(), slot_.reference()};
    placed->reference.origin = laid_.pose * placed->reference.origin;
  }
  context_.scene.setReference(placed);
  std::optional<scene::MapTrouble> trouble;
  if (slot_.broken() || slot_.phase() == session::MapSlot::Phase::Failed) {
    map::GridReference where;  // of one that could not be read at all: where its own origin lies
    if (there) where = slot_.reference();
    where.origin = laid_.pose * where.origin;
    trouble = {scene::gridCorners(where), !there, tr("Reference map"), sentences::sentenceOf(slot_.remark())};
  }
  context_.scene.setReferenceTrouble(std::move(trouble));
  QString said =
      tr("No reference map. Choose a plan or an older map of this place, to lay it under the map on screen.");
  if (there) said = mapShownText(slot_);
  if (there && slot_.remark()) said = words::about(said, sentences::sentenceOf(slot_.remark()));
  if (!there && !address_.isEmpty()) said = mapProgressText(slot_);
  if (slot_.phase() == session::MapSlot::Phase::Failed) said = sentences::sentenceOf(slot_.remark());
  dock_->setMap(said, there);
  dock_->setState(laid_.pose, laid_.pairs);
  tool_->setState(slot_.reference(), laid_.pose, laid_.pairs);
  allow(tool_action_, there, tr("There is no reference map."));
  if (!there && context_.tools.chosen() == tool_) context_.tools.putAway();
  checkAlignment();
  syncDifferences();
  // Another map of the robot is read through its session.
  session::Session* const session = context_.current.session();
  robot::Robot* const from = reader_                                    ? reader_.get()
                             : address_.startsWith(kOfRobot) && session ? &session->robot()
                                                                        : nullptr;
  const bool whole = there && slot_.settled() && from;
  Q_EMIT laidChanged(
      whole ? std::optional(
                  LaidMap{{slot_.cells(), slot_.reference()}, laid_.pose, from, slot_.key(), read_map_.name})
            : std::nullopt);
}

void ReferenceController::setLaid(Laid laid) {
  laid_ = std::move(laid);
  show();
  rememberForMap();
}

void ReferenceController::change(const QString& what, Laid laid, int drag) {
  const bool goes_on = drag > 0 && steps_.index() > 0 && steps_.command(steps_.index() - 1)->id() == drag;
  if (goes_on || !(laid == laid_)) steps_.push(new Step(*this, what, std::move(laid), drag));
}

void ReferenceController::setPairs(const QString& what, std::vector<placing::PointPair> pairs) {
  if (pairs.size() > kMostPairs)
    return context_.overlay.toasts()->add(
        Mark::Warning, tr("There are %1 pairs of points already, the most that are kept. Remove one first.")
                           .arg(kMostPairs));
  const geometry::Pose2 pose = placing::alignedBy(pairs, laid_.pose);
  change(what, {pose, std::move(pairs)});
}

std::optional<ReferenceController::Aligned> ReferenceController::alignable(bool submaps) const {
  const session::Session* const session = context_.current.session();
  if (!session || !slot_.cells()) return std::nullopt;
  const render::PlacedGrid reference{slot_.cells(), slot_.reference()};
  const session::MapSlot& whole = session->wholeMap();
  if (submaps) return Aligned{reference, std::nullopt, {}, laid_.pairs, {}};
  if (!whole.cells()) return std::nullopt;
  return Aligned{reference, render::PlacedGrid{whole.cells(), whole.reference()}, whole.shown().key,
                 laid_.pairs, whole.shown().fingerprint};
}

bool ReferenceController::showsSubmaps() const {
  const session::Session* const session = context_.current.session();
  if (!session || session->counts().shown == 0) return false;
  const bool whole = session->wholeMap().cells() && context_.scene.layerVisible(scene::Layer::WholeMap);
  return !whole;
}

void ReferenceController::onSubmapsChanged() {
  if (!aligned_ || aligned_->map || std::exchange(submaps_changed_, true)) return;
  showAlignment();
}

void ReferenceController::align() {
  forgetAlignment();
  if (laid_.pairs.size() > 1) {
    return say(
        tr("The pairs of points align the map by themselves: press Fit again. To align it by the walls, "
           "remove all pairs but one."));
  }
  align_next_ = true;
  dock_->setProgress(0);
  checkAlignment();
}

void ReferenceController::checkAlignment() {
  const bool submaps = aligned_ ? !aligned_->map : showsSubmaps();
  const std::optional<Aligned> now = alignable(submaps);
  const session::Session* const session = context_.current.session();
  if (align_next_ && now && isRead() && (submaps || session->wholeMap().settled())) {
    align_next_ = false;
    aligned_ = now;
    submaps_changed_ = false;
    pose_before_ = laid_.pose;
    startAligning(submaps);
  } else if (align_next_) {
    if (slot_.phase() == session::MapSlot::Phase::Failed) align_next_ = false;
    if (session && !submaps && session->wholeMap().settled() && !session->wholeMap().cells()) {
      align_next_ = false;
      said_ = tr("There is no map on screen to align with. Open one first.");
    }
  } else if (aligned_ && !(now && now->sameAs(*aligned_))) {
    forgetAlignment();
    said_ = tr("One of the maps, or a point, is not the same any more. Align again.");
  } else if (run_.running() && laid_.pose != pose_before_) {
    forgetAlignment();
    said_ = tr("The reference map was moved meanwhile. Align again.");
  }
  showAlignment();
}

void ReferenceController::startAligning(bool submaps) {
  const OnScreen on = submaps ? OnScreen(context_.scene.placedTextures()) : OnScreen(*aligned_->map);
  const auto job = [this, old_map = aligned_->reference, on, pairs = aligned_->pairs,
                    workers = context_.workers](const BackgroundRun::Running& run) -> BackgroundRun::Then {
    const auto found = alignOnScreen(old_map, on, pairs, workers, run);
    if (!found) {
      return [this, why = found.error()] {
        forgetAlignment();
        say(sentences::wordsOf(why));
      };
    }
    if (!*found) return {};
    return [this, alignment = **found] { onAligned(alignment); };
  };
  run_.start(job, [this](double done) { dock_->setProgress(done); });
}

void ReferenceController::onAligned(const align::Alignment& found) {
  found_ = found;
  if (found.sure()) change(tr("align the reference map"), {found.best->transform, laid_.pairs});
  showAlignment();
}

void ReferenceController::layCandidate(bool second) {
  const auto& candidate = second ? found_->second : found_->best;
  if (candidate) {
    change(second ? tr("show the second best place") : tr("show the best place"),
           {candidate->transform, laid_.pairs});
  }
}

void ReferenceController::say(const QString& sentence) {
  said_ = sentence;
  showAlignment();
}

void ReferenceController::showAlignment() {
  AlignmentShown shown;
  shown.running = run_.running() || align_next_ || fetching_;
  shown.said = said_;
  if (fetching_) {
    shown.said = tr("Fetching the map…");
  } else if (run_.running()) {
    shown.said = tr("Looking for the place by the walls…");
  } else if (align_next_) {
    shown.said = tr("Waiting until both maps are read…");
  } else if (found_) {
    const auto lies = [&](const std::optional<align::Candidate>& at) {
      return at && laid_.pose == at->transform;
    };
    const auto scored = [](const QString& which, const align::Candidate& candidate) {
      return tr("%1: score %2").arg(which, align::scoreText(candidate));
    };
    shown.best_laid = lies(found_->best);
    shown.second_laid = lies(found_->second);
    shown.offers = !found_->sure() && found_->best;
    shown.has_second = found_->second.has_value();
    const bool as_found = shown.best_laid || (!found_->sure() && laid_.pose == pose_before_);
    shown.said = as_found || shown.second_laid ? align::alignmentText(*found_)
                                               : tr("The reference map was moved since it was aligned.");
    const auto now = alignable(!aligned_->map);
    if (aligned_->map ? now && !now->sameCells(*aligned_) : submaps_changed_)
      shown.said = tr("The map on screen has changed since then. As it was: %1").arg(shown.said);
    QStringList figures;
    if (shown.offers) {
      figures << scored(tr("Best candidate"), *found_->best);
      if (found_->second) figures << scored(tr("Second best"), *found_->second);
    }
    if (as_found && found_->best) {
      figures << tr("Overlap: %1").arg(align::overlapText(found_->agreement));
      shown.agreement = found_->agreement;
    }
    shown.figures = figures.join(QLatin1Char('\n'));
  }
  dock_->setAlignment(shown);
}

void ReferenceController::forgetAlignment() {
  stopFetching();
  run_.forget();
  align_next_ = false;
  aligned_.reset();
  found_.reset();
  say({});
}

void ReferenceController::syncDifferences() {
  const session::Session* const session = context_.current.session();
  const bool there = slot_.cells() != nullptr, whole = session && session->wholeMap().cells();
  dock_->setWhyNoDifferences(!there   ? tr("There is no reference map.")
                             : !whole ? tr("There is no whole map on screen.")
                                      : QString());
  context_.scene.setReferenceDifferences(there && whole && dock_->differencesBox()->isChecked());
  const bool both = isRead() && whole && session->wholeMap().settled();
  std::optional<WallsOffMarks::Subject> marked;
  if (both && context_.scene.layerVisible(scene::Layer::WallsOff)) {
    marked = {{slot_.cells(), slot_.reference()},
              {session->wholeMap().cells(), session->wholeMap().reference()},
              laid_.pose};
  }
  walls_off_.show(marked);
  if (!marked || walls_off_.running()) dock_->setWallsOff(std::nullopt);
}

/// Of another map, or of one that is gone.
void ReferenceController::forgetSteps() {
  steps_.clear();
  if (context_.undo.activeStack() == &steps_) context_.undo.setActiveStack(other_steps_);
}

void ReferenceController::useTool(bool on, bool pairing) {
  tool_->setPairing(on && pairing);
  dock_->setTool(on && !pairing, on && pairing);
  if (on) {
    context_.undo.setActiveStack(&steps_);
    context_.tools.choose(tool_);
  } else if (context_.tools.chosen() == tool_) {
    context_.tools.putAway();
  }
}

}  // namespace mapwright::ui

#include "moc_reference_controller.cpp"
