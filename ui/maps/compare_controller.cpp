#include "ui/maps/compare_controller.h"

#include <QFileDialog>

#include "sentences/failure_sentence.h"
#include "ui/kit/folders.h"
#include "ui/maps/compare_control.h"
#include "ui/maps/map_files.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"

namespace mapwright::window {

CompareController::CompareController(WindowContext& context, PicturePlacing& placing, Read read,
                                     QObject* parent)
    : Controller(parent),
      context_(context),
      placing_(placing),
      read_(std::move(read)),
      control_(new CompareControl(&context.scene, &context.view, context.overlay.compareBar(), this)) {
  context_.actions.add({.id = "compare",
                        .text = tr("Com&pare…"),
                        .icon = "compare",
                        .keys = {"Ctrl+Shift+D"},
                        .tip = tr("Compare the open map with another one"),
                        .needs_session = true,
                        .menu = {MenuGroup::WholeMap, 10},
                        .bar = {BarGroup::Maps, 40}},
                       this, [this] { control_->start(); });
  connect(control_, &CompareControl::fileWanted, this, &CompareController::chooseFile);
}

CompareController::~CompareController() = default;

void CompareController::compareWith(const map::MapKey& key) { control_->start(key); }

void CompareController::compareWithSaved() {
  if (control_->active() && control_->second() == SecondMap(KeptState{})) return control_->end();
  control_->start(SecondMap(KeptState{}));
}

void CompareController::setSession(session::Session* session) {
  if (!session) source_.reset();
  control_->setSession(session);
}

bool CompareController::escape() {
  if (!control_->active()) return false;
  control_->end();
  return true;
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
      control_->startWith(std::move(*answer));
    } else {
      context_.overlay.toasts()->add(Mark::Bad,
                                     QString::fromStdString(sentences::sentenceOf(answer.error())));
    }
  });
}

}  // namespace mapwright::window

#include "moc_compare_controller.cpp"
