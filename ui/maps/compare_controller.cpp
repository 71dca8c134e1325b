#include "ui/maps/compare_controller.h"

#include <QEvent>
#include <QFileDialog>

#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/on_screen.h"
#include "ui/view/swipe_handle.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

using scene::CompareMode;

CompareController::CompareController(WindowContext& context, PicturePlacing& placing, Read read,
                                     QObject* parent)
    : Controller(parent),
      context_(context),
      placing_(placing),
      read_(std::move(read)),
      bar_(context.overlay.compareBar()),
      handle_(new SwipeHandle(&context.view)) {
  context_.actions.add({.id = "compare",
                        .text = tr("Com&pare…"),
                        .name = tr("Compare maps…"),
                        .icon = "compare",
                        .keys = {"Ctrl+Shift+D"},
                        .tip = tr("Compare the open map with another one"),
                        .needs_session = true,
                        .menu = {MenuGroup::WholeMap, 10},
                        .bar = {BarGroup::Maps, 40}},
                       this, [this] { start(); });
  context_.view.installEventFilter(this);
  connect(bar_, &CompareBar::secondWanted, this, &CompareController::choose);
  connect(bar_, &CompareBar::modeWanted, this, &CompareController::setMode);
  connect(bar_, &CompareBar::closed, this, &CompareController::end);
  connect(handle_, &SwipeHandle::moved, &context_.scene, &scene::MapScene::setSwipeAt);
  connect(handle_, &SwipeHandle::escaped, this, &CompareController::end);
}

CompareController::~CompareController() = default;

void CompareController::compareWithSaved() {
  if (active() && second_ == SecondMap(KeptState{})) return end();
  start(SecondMap(KeptState{}));
}

void CompareController::setSession(session::Session* session) {
  if (!session) source_.reset();
  if (session_) {
    for (QObject* source : std::initializer_list<QObject*>{&session_->wholeMap(), &session_->comparedMap(),
                                                           &session_->catalogue()})
      source->disconnect(this);
  }
  end();
  session_ = session;
  if (!session) return;
  connect(&session->catalogue(), &session::Catalogue::changed, this, &CompareController::sync);
  for (session::MapSlot* slot : {&session->wholeMap(), &session->comparedMap()}) {
    connect(slot, &session::MapSlot::changed, this, &CompareController::sync);
    connect(slot, &session::MapSlot::rowsArrived, this, &CompareController::sync);
  }
}

bool CompareController::escape() {
  if (!active()) return false;
  end();
  return true;
}

void CompareController::start(const std::optional<SecondMap>& second) {
  if (!session_) return;
  if (!active()) {
    context_.scene.setSwipeAt(0.5);
    context_.scene.setCompareMode(CompareMode::Swipe);
  }
  if (second) {
    choose(*second);
  } else if (!second_ && session_->robot().submapSource()) {
    choose(SubmapsAside{});
  }
  sync();
}

void CompareController::startWith(map::WholeMap map) {
  if (!session_) return;
  start(SecondMap(FileAside{}));
  session_->compareWith(std::move(map));
  sync();
}

void CompareController::choose(const SecondMap& second) {
  if (!session_) return;
  if (std::holds_alternative<FileAside>(second) && active() && sender() == bar_) {
    sync();  // the list shows the present comparison until a file has been chosen
    chooseFile();
    return;
  }
  second_ = second;
  if (const auto* key = std::get_if<map::MapKey>(&second)) {
    session_->compareWith(*key);
  } else if (std::holds_alternative<KeptState>(second)) {
    session_->keepForComparing();
  } else if (std::holds_alternative<SubmapsAside>(second)) {
    session_->compareWith(std::nullopt);
    if (context_.scene.compareMode() == CompareMode::Difference)
      context_.scene.setCompareMode(CompareMode::Swipe);
  }
  sync();
}

void CompareController::setMode(CompareMode mode) {
  context_.scene.setCompareMode(mode);
  sync();
}

void CompareController::end() {
  const bool was = active();
  second_.reset();
  context_.scene.setCompareMode(CompareMode::Off);
  if (session_) session_->compareWith(std::nullopt);
  sync();
  if (was) context_.view.setFocus();
}

void CompareController::sync() {
  bar_->sync(session_, context_.scene.compareMode(), second_);
  const HalfNames names = halfNames(session_, context_.scene);
  context_.scene.setHalfNames(names.left, names.right);
  const bool swiping = session_ && context_.scene.compareMode() == CompareMode::Swipe;
  handle_->setVisible(swiping);
  if (!swiping) return;
  handle_->setAt(context_.scene.swipeAt());
  bar_->raise();
}

bool CompareController::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &context_.view && event->type() == QEvent::Resize && !handle_->isHidden())
    handle_->setAt(context_.scene.swipeAt());
  return Controller::eventFilter(watched, event);
}

void CompareController::chooseFile() {
  const QString path = QFileDialog::getOpenFileName(&context_.window, tr("Compare with a map file"),
                                                    lastMapFolder(context_.settings), mapFileFilter());
  if (path.isEmpty()) return;
  if (isBarePicture(path)) {
    placing_.place(path, tr("Compare"), [this](const QString& address) { compareWithAddress(address); });
  } else {
    compareWithAddress(fileAddress(path));
  }
}

void CompareController::compareWithAddress(const QString& address) {
  if (!context_.current.session()) return;
  auto reader = read_(address);
  robot::WholeMapSource* const source = reader && *reader ? (*reader)->wholeMapSource() : nullptr;
  if (!source) {
    context_.overlay.toasts()->add(Mark::Bad, reader ? tr("This is not a map file.") : reader.error());
    return;
  }
  source_ = std::move(*reader);
  source_->connectToRobot();
  source->fetch({map::MapKind::File, {}}, [this](robot::Outcome<map::WholeMap> answer) {
    if (answer) {
      startWith(std::move(*answer));
    } else {
      context_.overlay.toasts()->add(Mark::Bad,
                                     QString::fromStdString(sentences::sentenceOf(answer.error())));
    }
  });
}

}  // namespace mapwright::ui

#include "moc_compare_controller.cpp"
