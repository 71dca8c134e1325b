#include "ui/overlays/overlay_review.h"

#include <utility>

#include <QAbstractListModel>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/overlays/overlay_text.h"

namespace mapwright::ui {

using overlays::OverlayDocument;

/// Words them when they are seen: there may be ten thousand.
class OverlayReview::Changes : public QAbstractListModel {
 public:
  Changes(const OverlayDocument& before, const OverlayDocument& after,
          std::vector<overlays::OverlayChange> changes, QObject* parent)
      : QAbstractListModel(parent), before_(before), after_(after), changes_(std::move(changes)) {}

  bool areBetween(const OverlayDocument& before, const OverlayDocument& after) const {
    return before.isSameText(before_) && after.isSameText(after_);
  }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(changes_.size());
  }
  QVariant data(const QModelIndex& index, int role) const override {
    return role == Qt::DisplayRole ? text(std::size_t(index.row())) : QVariant();
  }
  QString text(std::size_t row) const { return changeText(changes_[row], before_, after_); }

 private:
  OverlayDocument before_, after_;
  std::vector<overlays::OverlayChange> changes_;
};

OverlayReview::OverlayReview(const QString& map, const QString& robot, const OverlayDocument& before,
                             const OverlayDocument& after, std::vector<overlays::OverlayChange> changes,
                             const QString& note, QWidget* parent)
    : QDialog(parent),
      changes_(new Changes(before, after, std::move(changes), this)),
      save_(new QPushButton(robot.isEmpty() ? tr("Save the file") : tr("Save to the robot"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName(QStringLiteral("overlayReview"));
  setWindowTitle(tr("Save overlays"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QString what = overlayChangesText(changes_->rowCount());
  auto* const about = wrappedLabel(
      robot.isEmpty()
          ? tr("%1 to the overlays of %2. Everything else in the file stays as it is.").arg(what, map)
          : tr("%1 to %2 on the robot %3. The robot drives by them from then on; everything else "
               "stays as it is.")
                .arg(what, map, robot),
      this);
  auto* const list = new QListView(this);
  list->setAccessibleName(tr("Changes that are saved"));
  list->setSelectionMode(QAbstractItemView::NoSelection);
  list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list->setWordWrap(true);
  list->setLayoutMode(QListView::Batched);
  list->setModel(changes_);
  auto* const column = columnOf({about, {list, 1}}, 8);
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
  for (int row = 0; row < changes_->rowCount(); ++row) texts << changes_->text(std::size_t(row));
  return texts;
}

bool OverlayReview::shows(const OverlayDocument& before, const OverlayDocument& after) const {
  if (changes_->areBetween(before, after)) return true;
  const Changes now(before, after, overlays::changesBetween(before, after), nullptr);
  if (now.rowCount() != changes_->rowCount()) return false;
  for (std::size_t row = 0; row < std::size_t(now.rowCount()); ++row) {
    if (now.text(row) != changes_->text(row)) return false;
  }
  return true;
}

}  // namespace mapwright::ui

#include "moc_overlay_review.cpp"
