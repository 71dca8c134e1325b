#include "ui/overlays/overlay_review.h"

#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/overlays/overlay_text.h"

namespace mapwright::ui {

OverlayReview::OverlayReview(const QString& map, const QString& robot, const QStringList& changes,
                             const QString& note, QWidget* parent)
    : QDialog(parent),
      list_(new QListWidget(this)),
      save_(new QPushButton(robot.isEmpty() ? tr("Save the file") : tr("Save to the robot"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName(QStringLiteral("overlayReview"));
  setWindowTitle(tr("Save overlays"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QString what = overlayChangesText(changes.size());
  auto* const about = wrappedLabel(
      robot.isEmpty()
          ? tr("%1 to the overlays of %2. Everything else in the file stays as it is.").arg(what, map)
          : tr("%1 to %2 on the robot %3. The robot drives by them from then on; everything else "
               "stays as it is.")
                .arg(what, map, robot),
      this);
  list_->setAccessibleName(tr("Changes that are saved"));
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setWordWrap(true);
  list_->addItems(changes);
  for (int row = 0; row < list_->count(); ++row) list_->item(row)->setToolTip({});
  auto* const column = columnOf({about, {list_, 1}}, 8);
  if (!note.isEmpty()) column->addWidget(wrappedLabel(note, this));
  column->addLayout(rowOf({LayoutItem::rest(), cancel_, save_}, 8));
  setLayout(column);
  giveRoles(*save_, {cancel_});
  connect(save_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel_, &QPushButton::clicked, this, &QDialog::reject);
  resize(520, 360);
}

QStringList OverlayReview::changesShown() const {
  QStringList texts;
  for (int row = 0; row < list_->count(); ++row) texts << list_->item(row)->text();
  return texts;
}

}  // namespace mapwright::ui

#include "moc_overlay_review.cpp"
