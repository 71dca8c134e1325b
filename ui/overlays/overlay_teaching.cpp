#include "ui/overlays/overlay_teaching.h"

#include <utility>

#include <QMenu>

#include "map/live_state.h"
#include "overlays/overlay_edits.h"
#include "overlays/overlay_types.h"
#include "robot/overlay_store.h"
#include "sentences/failure_sentence.h"
#include "sentences/plural.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/overlays/overlay_marks_dialog.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/drawing.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

using robot::Sight;
using robot::SightEdge;

namespace {

const QString kMarksOwner = QStringLiteral("overlayMarks");

}  // namespace

OverlayTeaching::OverlayTeaching(WindowContext& context, edit::OverlayEditing* editing, OverlayTool* tool,
                                 QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      tool_(tool),
      menu_(new QMenu(tr("From the &robot"), &context.window)) {
  const QString edit = menuName(Menu::Edit);
  place_ =
      context_.actions.add(edit, QStringLiteral("overlayRobotPlace"), tr("Add the robot's &place"),
                           QStringLiteral("robot"), {QKeySequence(QStringLiteral("T"))}, Reach::OutsideText,
                           tr("The next point of what is drawn, or a new point, where the robot stands"));
  connect(place_, &QAction::triggered, this, &OverlayTeaching::addRobotsPlace);
  menu_->addAction(place_);
  menu_->addSeparator();
  things_.reserve(5);  // they are referred to
  addThing("overlayCharger", tr("&Charger that the robot sees"), tr("charger"), Sight::Charger,
           SightEdge::AsTheRobotHasIt, overlays::kCharger);
  addThing("overlayRackFront", tr("&Rack that the robot sees, front edge"), tr("rack point"), Sight::Rack,
           SightEdge::Front, overlays::kRackPoint);
  addThing("overlayRackRear", tr("Rack that the robot sees, r&ear edge"), tr("rack point"), Sight::Rack,
           SightEdge::Rear, overlays::kRackPoint);
  addThing("overlayPallet", tr("Pa&llet that the robot sees"), tr("pallet"), Sight::Pallet,
           SightEdge::AsTheRobotHasIt, overlays::kRackPoint);
  addThing("overlayTrailer", tr("&Trailer that the robot sees"), tr("trailer"), Sight::Trailer,
           SightEdge::AsTheRobotHasIt, overlays::kRackPoint);
  menu_->addSeparator();
  marks_ =
      context_.actions.add(edit, QStringLiteral("overlayMarks"), tr("Add landmar&ks and barcodes…"), {}, {},
                           Reach::Everywhere, tr("Add landmarks and barcodes that the robot has collected"));
  connect(marks_, &QAction::triggered, this, &OverlayTeaching::collect);
  menu_->addAction(marks_);
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::editableChanged})
    connect(editing_, signal, this, &OverlayTeaching::refresh);
  connect(editing_, &edit::OverlayEditing::opened, this, [this] {
    call_.cancel();
    if (dialog_) dialog_->close();
    refresh();
  });
  connect(&context_.scene, &scene::MapScene::robotPlaceChanged, this, &OverlayTeaching::refresh);
  refresh();
}

OverlayMarksDialog* OverlayTeaching::dialog() const { return dialog_; }

void OverlayTeaching::addThing(const char* id, const QString& text, const QString& called, Sight what,
                               SightEdge edge, int type) {
  QAction* const action = context_.actions.add(
      menuName(Menu::Edit), QLatin1String(id), text, {}, {}, Reach::Everywhere,
      tr("Add it as an overlay where the robot sees it, or move the selected one there"));
  things_.push_back({what, edge, type, action, called});
  const std::size_t index = things_.size() - 1;
  connect(action, &QAction::triggered, this, [this, index] { look(things_[index]); });
  menu_->addAction(action);
}

void OverlayTeaching::setSession(session::Session* session) {
  call_.cancel();
  if (dialog_) dialog_->close();
  if (session_) session_->disconnect(this);
  barcodes_.clear();
  there_ = false;
  session_ = session;
  if (session_) {
    connect(session_, &session::Session::liveHeard, this, [this](int what) {
      if (what == map::topicIndex<map::TrackedPose>() && robotPose().has_value() != robot_known_) refresh();
      const auto& barcode = session_->live().barcode;
      if (what == map::topicIndex<map::BarcodeMessage>() && barcode && barcode->pose && !barcode->id.empty())
        barcodes_.insert_or_assign(barcode->id, *barcode->pose);
    });
    connect(session_, &session::Session::frameChanged, this, [this] {
      barcodes_.clear();
      refresh();
    });
  }
  refresh();
}

void OverlayTeaching::setThere(bool there) {
  there_ = there;
  refresh();
}

robot::SightingSource* OverlayTeaching::source() const {
  robot::OverlayStore* const store = session_ ? session_->robot().overlayStore() : nullptr;
  return store ? store->sightings() : nullptr;
}

std::optional<geometry::Pose2> OverlayTeaching::robotPose() const {
  if (!session_ || !session_->live().robot_pose) return std::nullopt;
  if (context_.scene.robotPlace().where == map::Whereabouts::Elsewhere) return std::nullopt;
  return session_->live().robot_pose;
}

QString OverlayTeaching::noRobotReason() const {
  if (!editing_->isOpen()) return tr("Open the overlays of a map first.");
  if (!editing_->editable()) return tr("The overlays are being saved.");
  return there_ ? QString() : tr("The robot is not in this map.");
}

void OverlayTeaching::refresh() {
  const bool open = editing_->isOpen() && there_ && source() != nullptr;
  if (session_) session_->want(kMarksOwner, {}, open ? source()->topics() : QStringList());
  robot_known_ = robotPose().has_value();
  const QString why = noRobotReason();
  allow(place_, why.isEmpty() && robot_known_,
        why.isEmpty() ? tr("The position of the robot is unknown.") : why);
  const QString cannot = !why.isEmpty() ? why
                         : !source()    ? tr("This robot does not report what it sees.")
                         : asking()     ? tr("The robot has not answered yet.")
                                        : QString();
  for (const Thing& thing : things_) allow(thing.action, cannot.isEmpty(), cannot);
  allow(marks_, cannot.isEmpty(), cannot);
}

void OverlayTeaching::addRobotsPlace() {
  const auto pose = robotPose();
  if (!pose || !there_) return refresh();
  tool_->addPlace({pose->x_m, pose->y_m}, geometry::degreesFromRadians(pose->yaw_rad));
  show({pose->x_m, pose->y_m});
}

void OverlayTeaching::show(const Eigen::Vector2d& at_m) {
  const QPointF at = scene::toPoint(context_.scene.view().pixelFromWorld(at_m));
  if (!QRectF(context_.view.viewport()->rect()).contains(at)) context_.view.lookAt(at_m);
}

void OverlayTeaching::look(const Thing& thing) {
  robot::SightingSource* const sees = source();
  if (!sees || !there_ || !editing_->editable() || asking()) return;
  call_ = sees->look(thing.what, thing.edge, [this, &thing](robot::Outcome<robot::Sighting> outcome) {
    // Over only after this.
    QMetaObject::invokeMethod(this, &OverlayTeaching::refresh, Qt::QueuedConnection);
    if (outcome) return onSighting(thing, *outcome);
    if (outcome.error().kind == map::FailureKind::Cancelled) return;
    context_.overlay.toasts()->add(
        Mark::Warning,
        tr("No %1 was added. %2")
            .arg(thing.called, QString::fromStdString(sentences::failureReason(outcome.error()))));
  });
  refresh();
}

void OverlayTeaching::onSighting(const Thing& thing, const robot::Sighting& sighting) {
  if (!editing_->editable()) return;
  const overlays::SeenPlace seen{{sighting.pose.x_m, sighting.pose.y_m},
                                 geometry::degreesFromRadians(sighting.pose.yaw_rad),
                                 sighting.reference};
  const auto key = editing_->only();
  const Feature* const selected = key ? editing_->find(*key) : nullptr;
  if (selected && selected->shape() == overlays::Shape::Point && selected->type() == thing.type) {
    editing_->set(*key, overlays::seenAgain(*selected, seen), editing_->saying(tr("move %1")));
    context_.overlay.toasts()->add(Mark::Good, editing_->saying(tr("Moved to where the robot sees it: %1")));
  } else {
    const Feature point =
        overlays::seenFeature(editing_->document().mine(), thing.type, seen, editing_->newId());
    editing_->put({point}, {}, tr("add %1").arg(thing.called));
    context_.overlay.toasts()->add(Mark::Good, tr("Added where the robot sees it: %1").arg(thing.called));
  }
  show(seen.at_m);
}

void OverlayTeaching::collect() {
  if (dialog_) return dialog_->raise();
  robot::SightingSource* const sees = source();
  if (!sees || !there_ || !editing_->editable() || asking()) return;
  call_ = sees->collectedLandmarks([this](robot::Outcome<robot::CollectedLandmarks> outcome) {
    QMetaObject::invokeMethod(this, &OverlayTeaching::refresh, Qt::QueuedConnection);
    if (outcome) {
      const auto older = qint64(outcome->older);
      return offer(outcome->landmarks, older == 0
                                           ? QString()
                                           : tr("The newest %1 collections of the robot were read, of %2.")
                                                 .arg(countText(qint64(outcome->files)),
                                                      countText(qint64(outcome->files) + older)));
    }
    if (outcome.error().kind == map::FailureKind::Cancelled) return;
    offer({}, tr("What the robot has collected earlier could not be read. %1")
                  .arg(QString::fromStdString(sentences::failureReason(outcome.error()))));
  });
  refresh();
}

void OverlayTeaching::offer(const std::vector<map::Landmark>& collected, const QString& note) {
  if (!editing_->isOpen() || !session_) return;
  using Kind = overlays::Mark::Kind;
  std::vector<overlays::Mark> marks;
  for (const map::Landmark& mark : collected) marks.push_back({Kind::Landmark, mark.id, mark.position_m});
  for (const map::Landmark& mark : session_->live().landmarks) {
    if (!mark.id.empty()) marks.push_back({Kind::Landmark, mark.id, mark.position_m});
  }
  for (const auto& [id, pose] : barcodes_)
    marks.push_back({Kind::Barcode, id, {pose.x_m, pose.y_m}, geometry::degreesFromRadians(pose.yaw_rad)});
  if (marks.empty()) {
    context_.overlay.toasts()->add(
        Mark::Warning, note.isEmpty()
                           ? tr("The robot has collected no landmarks and has seen no barcodes since it was "
                                "connected.")
                           : note);
    return;
  }
  dialog_ =
      new OverlayMarksDialog(overlays::offersOf(editing_->document().mine(), marks), note, &context_.window);
  connect(dialog_, &QDialog::accepted, this, [this] {
    if (dialog_) addMarks(dialog_->chosen());
  });
  dialog_->open();
}

void OverlayTeaching::addMarks(const std::vector<overlays::MarkOffer>& chosen) {
  if (chosen.empty() || !editing_->editable()) return;
  const overlays::OverlayDocument among = editing_->document().mine();
  // They may have been changed meanwhile: what is there now counts.
  std::vector<overlays::Mark> marks;
  for (const overlays::MarkOffer& offer : chosen) marks.push_back(offer.mark);
  const std::vector<FeatureKey> keys = editing_->document().keysOfMine();
  std::vector<Feature> added;
  std::map<FeatureKey, Feature> moved;
  for (const overlays::MarkOffer& offer : overlays::offersOf(among, marks)) {
    if (offer.present) {
      moved.emplace(keys[*offer.present], overlays::withMark(among.features()[*offer.present], offer.mark));
    } else {
      added.push_back(overlays::markFeature(among, offer.mark, editing_->newId()));
    }
  }
  const auto count = qsizetype(added.size() + moved.size());
  const QString text = sentences::counted(tr("%1 marks", nullptr, sentences::formOf(count)), count);
  editing_->put(added, moved, tr("add %1").arg(text));
  if (added.empty()) {
    std::set<FeatureKey> selected;
    for (const auto& [key, feature] : moved) selected.insert(key);
    editing_->select(selected);
  }
  context_.overlay.toasts()->add(Mark::Good, tr("Taken from the robot: %1").arg(text));
}

}  // namespace mapwright::ui

#include "moc_overlay_teaching.cpp"
