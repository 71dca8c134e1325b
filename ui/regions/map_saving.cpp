#include "ui/regions/map_saving.h"

#include <utility>

#include "jobs/change_map.h"
#include "sentences/failure_sentence.h"
#include "ui/regions/save_map_dialog.h"
#include "words/qt_plain.h"

namespace mapwright::window {

MapSaving::MapSaving(QWidget& parent_of_dialog, std::function<void(Mark, const QString&)> toast,
                     QObject* parent)
    : QObject(parent), window_(parent_of_dialog), toast_(std::move(toast)) {}

void MapSaving::close() {
  if (dialog_) dialog_->close();
}

void MapSaving::ask(robot::MapDispatch* dispatch) {
  if (!dispatch || dialog_) return;
  dispatch_ = dispatch;
  dialog_ = new SaveMapDialog(&window_);
  connect(dialog_, &QDialog::finished, this, [this] {
    saving_.cancel();
    dialog_.clear();  // it goes by itself
    Q_EMIT changed();
  });
  connect(dialog_, &SaveMapDialog::saveWanted, this, [this](const QString& filename) {
    if (!dispatch_) return dialog_->refuse(tr("The robot is no longer connected."));
    if (const QString why = jobs::whyNoFilename(filename); !why.isEmpty()) return dialog_->refuse(why);
    dialog_->wait();
    saving_ = dispatch_->save(
        filename.toStdString(), [self = QPointer(this)](const robot::Outcome<std::string>& outcome) {
          if (!self || !self->dialog_) return;
          if (!outcome) {
            return self->dialog_->refuse(QString::fromStdString(sentences::sentenceOf(outcome.error())));
          }
          self->toast_(
              Mark::Good,
              tr("The robot saved its map as %1.").arg(words::plainName(QString::fromStdString(*outcome))));
          self->dialog_->accept();
        });
  });
  dialog_->open();
  Q_EMIT changed();
}

}  // namespace mapwright::window

#include "moc_map_saving.cpp"
