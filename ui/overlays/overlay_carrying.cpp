#include "ui/overlays/overlay_carrying.h"

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "overlays/overlay_box.h"
#include "overlays/overlay_shapes.h"
#include "robot/overlay_store.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {
namespace {

QString unreadableOldOverlays(const QString& why) {
  return OverlayCarrying::tr("The overlays of the reference map cannot be read. %1").arg(why);
}

QString capitalized(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

OverlayCarrying::OverlayCarrying(WindowContext& context, edit::OverlayEditing* editing, There there,
                                 QObject* parent)
    : Carrying(context,
               {.title = tr("Carry over overlays"),
                .one = tr("Overlay"),
                .named = tr("What becomes of the overlays"),
                .carried = tr("It is among the overlays of the map on screen now."),
                .there = tr("The map on screen has it already, and it stays as it is there."),
                .looking = tr("Looking at the walls around each overlay…"),
                .hint = tr("Lay the old map under this one as a reference map, and align it. Then press "
                           "Carry over overlays… there.")},
               QStringLiteral("carryOverOverlays"), 38, parent),
      editing_(editing),
      there_(std::move(there)),
      marks_(&context.scene) {
  connect(editing_, &edit::OverlayEditing::opened, this, &OverlayCarrying::forgetCarried);
}

QString OverlayCarrying::whyNotBetween(robot::Robot& reader) const {
  return reader.overlayStore() ? there_.why_not() : tr("The reference map has no overlays.");
}

void OverlayCarrying::read(robot::Robot& reader, const map::MapKey& key) {
  old_text_.reset();
  reader.overlayStore()->read(key, [this, asked = turn()](robot::Outcome<robot::OverlayText> answer) {
    if (asked != turn()) return;
    if (!answer)
      return giveUp(unreadableOldOverlays(QString::fromStdString(sentences::sentenceOf(answer.error()))));
    old_text_ = std::move(answer->text);
    if (!editing_->isOpen()) there_.read();
    startIfOpen();
  });
}

void OverlayCarrying::update() {
  refresh();
  startIfOpen();
}

void OverlayCarrying::startIfOpen() {
  if (!old_text_ || !lookedAt()) return;
  if (const QString why = there_.why_not(); !why.isEmpty()) {
    old_text_.reset();
    return giveUp(why);
  }
  if (!editing_->isOpen()) return;
  const carry::CarryOptions options{.radius_m = there_.radius_m(), .adjust = adjusts()};
  start([this, text = *std::exchange(old_text_, std::nullopt), mine = editing_->document().mine(),
         map = lookedAt()->map, options](const carry::Site& site) -> BackgroundRun::Then {
    const auto document = overlays::OverlayDocument::read(text);
    if (!document) {
      return [this, why = document.error()] { giveUp(unreadableOldOverlays(sentences::sentenceOf(why))); };
    }
    return [this, found = carry::carriedOverlays(site, *document, mine, map, options), document = *document] {
      onFound(found, document);
    };
  });
}

void OverlayCarrying::onFound(std::vector<carry::CarriedFeature> found,
                              const overlays::OverlayDocument& old_overlays) {
  const auto unusable = qsizetype(old_overlays.features().size() - found.size());
  const QString left_out =
      unusable == 0 ? QString()
                    : tr("Left out, because coordinates cannot be used: %1.").arg(featuresText(unusable));
  if (found.empty()) return giveUp(unusable == 0 ? tr("The reference map has no overlays.") : left_out);
  std::map<std::size_t, int> row_of;  // of the old document
  for (std::size_t i = 0; i < found.size(); ++i) row_of[found[i].feature] = int(i);
  std::vector<CarryRow> rows;
  for (const carry::CarriedFeature& one : found) {
    const overlays::Feature& feature = old_overlays.features()[one.feature];
    CarryRow row{capitalized(overlayCalled(feature)), one.carried, feature.id()};
    for (const std::size_t other : one.with) row.with.push_back(row_of.at(other));
    rows.push_back(std::move(row));
  }
  found_ = std::move(found);
  setRows(std::move(rows), left_out);
}

const overlays::Feature* OverlayCarrying::placed(int row) const {
  const auto became = became_.find(rows()[std::size_t(row)].id);
  return became == became_.end() ? nullptr : editing_->find(became->second);
}

std::vector<CarryRow::State> OverlayCarrying::statesNow() const {
  using State = CarryRow::State;
  std::set<std::string> ids;
  const overlays::EditingDocument& document = editing_->document();
  for (overlays::FeatureKey key = 0; key < document.size(); ++key) {
    if (const auto& feature = document.find(key)) ids.insert(feature->id());
  }
  std::vector<State> states;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const std::string id = found_[i].moved.id();
    const bool there = id.empty() ? found_[i].there_already : ids.contains(id);
    states.push_back(placed(int(i)) ? State::Carried : there ? State::There : State::Open);
  }
  // What belongs together goes together.
  const std::vector<State> alone = states;
  for (std::size_t i = 0; i < states.size(); ++i) {
    for (const int other : rows()[i].with) {
      if (alone[i] == State::Open && alone[std::size_t(other)] != State::Open) states[i] = State::OtherThere;
    }
  }
  return states;
}

geometry::WorldRect OverlayCarrying::boundsOf(int row) const {
  const overlays::Feature* const there = placed(row);
  geometry::WorldRect bounds;
  for (const overlays::Path& path :
       overlays::shapesOf(there ? *there : found_[std::size_t(row)].moved).paths) {
    for (const Eigen::Vector2d& point : path.points) bounds.extend(point);
  }
  return bounds;
}

void OverlayCarrying::mark(std::optional<int> row) {
  std::vector<OverlayMark> marks;
  if (row && !placed(*row)) {
    for (const overlays::Path& path : overlays::shapesOf(found_[std::size_t(*row)].moved).paths) {
      if (!path.points.empty()) marks.push_back({OverlayMark::Kind::Added, path.shape, path.points});
    }
  }
  marks_.show(std::move(marks));
}

bool OverlayCarrying::put(const std::vector<int>& going) {
  std::vector<overlays::Feature> features;
  qint64 boxes = 0;
  for (const int row : going) {
    const carry::CarriedFeature& one = found_[std::size_t(row)];
    features.push_back(one.moved);
    boxes += one.box_removed;
  }
  const QString counted = featuresText(qsizetype(features.size()));
  const auto keys = editing_->put(features, {}, tr("carry over %1").arg(counted));
  for (std::size_t i = 0; i < keys.size(); ++i) became_[rows()[std::size_t(going[i])].id] = keys[i];
  if (keys.empty()) return false;
  context_.scene.setLayerVisible(scene::Layer::Overlays, true);
  context_.overlay.toasts()->add(Mark::Good,
                                 tr("%1 carried over. Nothing has been sent or saved yet.").arg(counted));
  if (boxes > 0)
    context_.overlay.toasts()->add(
        Mark::Warning, tr("Boxes (bbox) left out because they did not fit their overlay: %1.").arg(boxes));
  if (!overlays::boxFits(editing_->document().mine()))
    context_.overlay.toasts()->add(
        Mark::Warning, tr("The box (bbox) of all overlays did not fit them before, and stays as it is."));
  return true;
}

}  // namespace mapwright::ui

#include "moc_overlay_carrying.cpp"
