#include "edit/overlays/overlay_editing.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <QRandomGenerator>

#include "overlays/overlay_box.h"
#include "overlays/overlay_paste.h"
#include "overlays/overlay_sentence.h"
#include "overlays/overlay_shapes.h"

namespace mapwright::edit {

using overlays::EditingDocument;
using overlays::Feature;
using overlays::FeatureEdit;
using overlays::FeatureKey;
using overlays::featuresText;
using overlays::kCollectionKey;
using overlays::overlayCalled;
using overlays::OverlayDocument;

namespace {

Feature shiftedBy(const Feature& feature, const Eigen::Vector2d& by_m) {
  return overlays::withItsBoxes(overlays::movedBy(feature, by_m), feature);
}

}  // namespace

/// A step of the document, which keeps what it changes itself: others' changes come below it.
class OverlayEditing::Command : public QUndoCommand {
 public:
  Command(OverlayEditing* editing, const QString& text) : QUndoCommand(text), editing_(editing) {}
  void undo() override { editing_->step(false); }
  void redo() override {
    if (std::exchange(done_, true)) editing_->step(true);
  }

 private:
  OverlayEditing* editing_;
  bool done_ = false;
};

OverlayEditing::OverlayEditing(QObject* parent) : QObject(parent) {}

OverlayEditing::~OverlayEditing() = default;

void OverlayEditing::open(OverlayDocument held) {
  undo_.clear();
  document_ = EditingDocument(std::move(held));
  open_ = true;
  locked_ = false;
  waiting_ = 0;
  preview_.clear();
  selected_.clear();
  gesture_ = 0;
  Q_EMIT opened();
  Q_EMIT selectionChanged();
  Q_EMIT changed();
}

void OverlayEditing::close() {
  if (!open_) return;
  undo_.clear();
  document_ = {};
  open_ = locked_ = false;
  waiting_ = 0;
  preview_.clear();
  selected_.clear();
  Q_EMIT opened();
  Q_EMIT selectionChanged();
  Q_EMIT changed();
}

void OverlayEditing::setLocked(bool locked) {
  if (std::exchange(locked_, locked) == locked) return;
  if (locked_) setPreview({});
  const int waiting = std::exchange(waiting_, 0);
  for (int i = 0; i < std::abs(waiting); ++i) step(waiting > 0);
  Q_EMIT editableChanged();
}

void OverlayEditing::select(std::set<FeatureKey> keys) {
  std::erase_if(keys, [this](FeatureKey key) { return key == kCollectionKey || !document_.find(key); });
  if (keys == selected_) return;
  selected_ = std::move(keys);
  gesture_ = 0;
  Q_EMIT selectionChanged();
}

void OverlayEditing::toggle(FeatureKey key) {
  std::set<FeatureKey> keys = selected_;
  if (keys.erase(key) == 0) keys.insert(key);
  select(std::move(keys));
}

std::optional<FeatureKey> OverlayEditing::only() const {
  return selected_.size() == 1 ? std::optional(*selected_.begin()) : std::nullopt;
}

const Feature* OverlayEditing::find(FeatureKey key) const {
  if (const auto shown = preview_.find(key); shown != preview_.end()) return &shown->second;
  const auto& feature = document_.find(key);
  return feature ? &*feature : nullptr;
}

void OverlayEditing::setPreview(Preview preview) {
  if (preview.empty() && preview_.empty()) return;
  preview_ = std::move(preview);
  Q_EMIT previewChanged();
}

void OverlayEditing::applyPreview(const QString& text) {
  std::vector<FeatureEdit> edits;
  for (auto& [key, feature] : std::exchange(preview_, {}))
    edits.push_back({key, document_.find(key), std::move(feature)});
  Q_EMIT previewChanged();
  change(std::move(edits), text);
}

void OverlayEditing::record(const QString& text, const std::function<void()>& what) {
  if (!editable()) return;
  setPreview({});
  const std::size_t before = document_.stepsDone();
  what();
  if (document_.stepsDone() != before) undo_.push(new Command(this, text));
  prune();
  Q_EMIT changed();
}

void OverlayEditing::change(std::vector<FeatureEdit> edits, const QString& text, Gesture gesture) {
  for (FeatureEdit& edit : edits) {
    if (edit.before && edit.after && edit.key != kCollectionKey)
      edit.after = overlays::withItsBoxes(*edit.after, *edit.before);
  }
  const bool joins = gesture != 0 && gesture == gesture_ && !undo_.canRedo() && undo_.canUndo();
  record(text, [&] { document_.change(std::move(edits), joins); });
  gesture_ = gesture;
}

void OverlayEditing::step(bool forward) {
  if (locked_) {
    waiting_ += forward ? 1 : -1;
    return;
  }
  setPreview({});
  forward ? document_.redo() : document_.undo();
  gesture_ = 0;
  prune();
  Q_EMIT changed();
}

void OverlayEditing::prune() {
  std::set<FeatureKey> left = selected_;
  std::erase_if(left, [this](FeatureKey key) { return !document_.find(key); });
  if (left == selected_) return;
  selected_ = std::move(left);
  Q_EMIT selectionChanged();
}

void OverlayEditing::set(FeatureKey key, const Feature& feature, const QString& text, Gesture gesture) {
  if (document_.find(key) || key == kCollectionKey)
    change({{key, document_.find(key), feature}}, text, gesture);
}

void OverlayEditing::changeSelected(const QString& text, const std::function<Feature(const Feature&)>& how,
                                    Gesture gesture) {
  std::vector<FeatureEdit> edits;
  for (const FeatureKey key : selected_)
    edits.push_back({key, document_.find(key), how(*document_.find(key))});
  change(std::move(edits), text, gesture);
}

QString OverlayEditing::saying(const QString& pattern) const {
  const auto key = only();
  const Feature* const feature = key ? find(*key) : nullptr;
  return pattern.arg(feature ? overlayCalled(*feature) : featuresText(qsizetype(selected_.size())));
}

void OverlayEditing::removeSelected() {
  std::vector<FeatureEdit> edits;
  for (const FeatureKey key : selected_) edits.push_back({key, document_.find(key), std::nullopt});
  if (!edits.empty()) change(std::move(edits), saying(tr("delete %1")));
}

void OverlayEditing::restore(const std::set<FeatureKey>& keys) {
  std::vector<FeatureEdit> edits;
  for (const FeatureKey key : keys) {
    if (!document_.find(key)) edits.push_back({key, std::nullopt, document_.findBase(key)});
  }
  if (!edits.empty()) change(std::move(edits), tr("restore %1").arg(featuresText(qsizetype(edits.size()))));
}

std::string OverlayEditing::newId() const {
  overlays::IdBytes bytes{};
  for (auto& byte : bytes) byte = std::uint8_t(QRandomGenerator::global()->bounded(256));
  return overlays::idOf(bytes);
}

std::vector<FeatureKey> OverlayEditing::put(const std::vector<Feature>& added,
                                            const std::map<FeatureKey, Feature>& changed,
                                            const QString& text) {
  if (!editable()) return {};
  std::vector<FeatureEdit> edits;
  std::vector<FeatureKey> keys;
  for (const auto& [key, feature] : changed) edits.push_back({key, document_.find(key), feature});
  for (const Feature& feature : added) {
    keys.push_back(document_.newKey());
    edits.push_back({keys.back(), std::nullopt, feature});
  }
  change(std::move(edits), text);
  if (!keys.empty()) select({keys.begin(), keys.end()});
  return keys;
}

std::vector<Feature> OverlayEditing::madeFree(const std::vector<Feature>& features) const {
  return overlays::madeFree(document_.mine(), features, [this] { return newId(); });
}

void OverlayEditing::duplicateSelected() {
  constexpr double kAsideM = 0.5;
  if (!editable()) return;
  std::vector<Feature> features;
  for (const FeatureKey key : selected_) features.push_back(*document_.find(key));
  features = madeFree(features);
  for (Feature& feature : features) feature = shiftedBy(feature, {kAsideM, -kAsideM});
  put(features, {}, saying(tr("duplicate %1")));
}

FeatureKey OverlayEditing::add(overlays::Shape shape, const std::vector<Eigen::Vector2d>& points, int type) {
  if (!editable()) return document_.size();
  const FeatureKey key = document_.newKey();
  const Feature feature = overlays::newFeature(document_.mine(), shape, points, type, newId());
  change({{key, std::nullopt, feature}}, tr("add %1").arg(overlayCalled(feature)));
  select({key});
  return key;
}

std::string OverlayEditing::copied() const {
  if (selected_.empty()) return {};
  OverlayDocument copies;
  for (const FeatureKey key : selected_) copies.add(*document_.find(key));
  return copies.text();
}

void OverlayEditing::paste(const std::vector<Feature>& features, const std::optional<Eigen::Vector2d>& at_m) {
  if (!editable()) return;
  std::vector<Feature> pasted = madeFree(features);
  geometry::WorldRect around;
  for (const Feature& feature : pasted) {
    for (const overlays::Path& path : overlays::shapesOf(feature).paths) {
      for (const Eigen::Vector2d& point : path.points) around.extend(point);
    }
  }
  if (at_m && !around.empty()) {
    for (Feature& feature : pasted) feature = shiftedBy(feature, *at_m - around.center());
  }
  put(pasted, {}, tr("paste %1").arg(featuresText(qsizetype(pasted.size()))));
}

geometry::WorldRect OverlayEditing::bounds() const {
  geometry::WorldRect bounds;
  for (const FeatureKey key : selected_) {
    const Feature* const feature = find(key);
    if (!feature) continue;
    for (const overlays::Path& path : overlays::shapesOf(*feature).paths) {
      for (const Eigen::Vector2d& point : path.points) bounds.extend(point);
    }
  }
  return bounds;
}

void OverlayEditing::rebase(const OverlayDocument& theirs, bool saved) {
  if (!open_) return;
  setPreview({});
  gesture_ = 0;
  if (saved) document_.markSaved();
  document_.rebase(theirs);
  prune();
  Q_EMIT changed();
}

void OverlayEditing::keepMine(const EditingDocument::Conflict& conflict) {
  document_.keepMine(conflict);
  Q_EMIT changed();
}

void OverlayEditing::useTheirs(const EditingDocument::Conflict& conflict) {
  record(tr("take their version"), [&] { document_.useTheirs(conflict); });
}

void OverlayEditing::restoreDraft(const OverlayDocument& base, const OverlayDocument& mine,
                                  const QString& text) {
  record(text, [&] { document_.restoreDraft(base, mine); });
}

void OverlayEditing::revert() {
  std::vector<FeatureEdit> edits;
  for (FeatureKey key = 0; key < document_.size(); ++key) {
    if (document_.isUnsaved(key)) edits.push_back({key, document_.find(key), document_.findBase(key)});
  }
  if (document_.isUnsaved(kCollectionKey))
    edits.push_back({kCollectionKey, document_.find(kCollectionKey), document_.findBase(kCollectionKey)});
  change(std::move(edits), tr("discard the changes"));
}

void OverlayEditing::become(const OverlayDocument& version, const QString& text) {
  record(text, [&] { document_.change(document_.editsTo(version)); });
}

}  // namespace mapwright::edit

#include "moc_overlay_editing.cpp"
