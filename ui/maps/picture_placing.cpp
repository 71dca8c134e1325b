#include "ui/maps/picture_placing.h"

#include "ui/maps/map_files.h"
#include "ui/maps/picture_dialog.h"

namespace mapwright::window {

PicturePlacing::PicturePlacing(QWidget* window,
                               std::function<QStringList(const QString& picture)> yamls_naming,
                               std::shared_ptr<work::Workers> workers)
    : QObject(window), window_(window), yamls_naming_(std::move(yamls_naming)), share_(std::move(workers)) {}

void PicturePlacing::place(const QString& path, const QString& accept_text, const Then& then) {
  const quint64 asked = ++asked_;
  const auto know = [this, asked, path, accept_text, then](const QStringList& yamls) {
    if (asked != asked_) return;
    yamls.size() == 1 ? then(fileAddress(yamls.front())) : ask(path, yamls, accept_text, then);
  };
  if (!yamls_naming_) return know({});
  // A folder on a slow network drive must not block the window.
  share_.startLong([this, know, path] {
    QMetaObject::invokeMethod(
        this, [know, yamls = yamls_naming_(path)] { know(yamls); }, Qt::QueuedConnection);
  });
}

PictureDialog* PicturePlacing::dialog() const { return dialog_; }

void PicturePlacing::ask(const QString& path, const QStringList& named_by, const QString& accept_text,
                         const Then& then) {
  delete dialog_;
  dialog_ = new PictureDialog(path, named_by, accept_text, window_);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &QDialog::accepted, this, [this, path, then] {
    if (const auto placement = dialog_->placement()) then(fileAddress(path, placement));
  });
  dialog_->open();
}

}  // namespace mapwright::window

#include "moc_picture_placing.cpp"
