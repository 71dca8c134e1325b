#include "ui/maps/compare_control.h"

#include <QEvent>

#include "ui/view/map_view.h"
#include "ui/view/on_screen.h"
#include "ui/view/swipe_handle.h"

namespace mapwright::window {

using scene::CompareMode;

CompareControl::CompareControl(scene::MapScene* scene, MapView* view, CompareBar* bar, QObject* parent)
    : QObject(parent), scene_(scene), view_(view), bar_(bar), handle_(new SwipeHandle(view)) {
  view_->installEventFilter(this);
  connect(bar_, &CompareBar::secondWanted, this, &CompareControl::choose);
  connect(bar_, &CompareBar::modeWanted, this, &CompareControl::setMode);
  connect(bar_, &CompareBar::closed, this, &CompareControl::end);
  connect(handle_, &SwipeHandle::moved, scene_, &scene::MapScene::setSwipeAt);
  connect(handle_, &SwipeHandle::escaped, this, &CompareControl::end);
}

void CompareControl::setSession(session::Session* session) {
  if (session_) {
    for (QObject* source : std::initializer_list<QObject*>{&session_->wholeMap(), &session_->comparedMap(),
                                                           &session_->catalogue()})
      source->disconnect(this);
  }
  end();
  session_ = session;
  if (!session) return;
  connect(&session->catalogue(), &session::Catalogue::changed, this, &CompareControl::sync);
  for (session::MapSlot* slot : {&session->wholeMap(), &session->comparedMap()}) {
    connect(slot, &session::MapSlot::changed, this, &CompareControl::sync);
    connect(slot, &session::MapSlot::rowsArrived, this, &CompareControl::sync);
  }
}

void CompareControl::start(const std::optional<SecondMap>& second) {
  if (!session_) return;
  if (!active()) {
    scene_->setSwipeAt(0.5);
    scene_->setCompareMode(CompareMode::Swipe);
  }
  if (second) {
    choose(*second);
  } else if (!second_ && session_->robot().submapSource()) {
    choose(SubmapsAside{});
  }
  sync();
}

void CompareControl::startWith(map::WholeMap map) {
  if (!session_) return;
  start(SecondMap(FileAside{}));
  session_->compareWith(std::move(map));
  sync();
}

void CompareControl::choose(const SecondMap& second) {
  if (!session_) return;
  if (std::holds_alternative<FileAside>(second) && active() && sender() == bar_) {
    sync();  // the list shows the present comparison until a file has been chosen
    Q_EMIT fileWanted();
    return;
  }
  second_ = second;
  if (const auto* key = std::get_if<map::MapKey>(&second)) {
    session_->compareWith(*key);
  } else if (std::holds_alternative<KeptState>(second)) {
    session_->keepForComparing();
  } else if (std::holds_alternative<SubmapsAside>(second)) {
    session_->compareWith(std::nullopt);
    if (scene_->compareMode() == CompareMode::Difference) scene_->setCompareMode(CompareMode::Swipe);
  }
  sync();
}

void CompareControl::setMode(CompareMode mode) {
  scene_->setCompareMode(mode);
  sync();
}

void CompareControl::end() {
  const bool was = active();
  second_.reset();
  scene_->setCompareMode(CompareMode::Off);
  if (session_) session_->compareWith(std::nullopt);
  sync();
  if (!was) return;
  view_->setFocus();
  Q_EMIT ended();
}

void CompareControl::sync() {
  bar_->sync(session_, scene_->compareMode(), second_);
  const HalfNames names = halfNames(session_, *scene_);
  scene_->setHalfNames(names.left, names.right);
  const bool swiping = session_ && scene_->compareMode() == CompareMode::Swipe;
  handle_->setVisible(swiping);
  if (!swiping) return;
  handle_->setAt(scene_->swipeAt());
  bar_->raise();
}

bool CompareControl::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize && !handle_->isHidden())
    handle_->setAt(scene_->swipeAt());
  return QObject::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_compare_control.cpp"
