#include "ui/overlays/overlay_marks_dialog.h"

#include <utility>

#include <QHeaderView>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "sentences/plural.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "words/fixed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

enum MarkColumn { kMarkColumn, kMarkPlaceColumn, kMarkStateColumn };

}  // namespace

OverlayMarksDialog::OverlayMarksDialog(std::vector<overlays::MarkOffer> offers, const QString& note,
                                       QWidget* parent)
    : QDialog(parent),
      offers_(std::move(offers)),
      table_(new QTableWidget(int(offers_.size()), 3, this)),
      take_(new QPushButton(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName(QStringLiteral("overlayMarks"));
  setWindowTitle(tr("Landmarks and barcodes"));
  setAttribute(Qt::WA_DeleteOnClose);
  table_->setAccessibleName(tr("What the robot has collected"));
  table_->setHorizontalHeaderLabels({tr("Mark"), tr("Place"), tr("State")});
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(22);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->resizeSection(kMarkPlaceColumn, 130);
  table_->horizontalHeader()->resizeSection(kMarkStateColumn, 210);
  new NameColumn(table_, table_->horizontalHeader(), kMarkColumn,
                 {{kMarkStateColumn, 120}, {kMarkPlaceColumn, 80}});
  for (int row = 0; row < table_->rowCount(); ++row) {
    const overlays::MarkOffer& offer = offers_[std::size_t(row)];
    const QString id = words::plainName(offer.mark.id);
    const bool landmark = offer.mark.kind == overlays::Mark::Kind::Landmark;
    auto* const mark = new QTableWidgetItem(landmark ? tr("Landmark %1").arg(id) : tr("Barcode %1").arg(id));
    mark->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    // What would change something that somebody placed needs a decision.
    mark->setCheckState(offer.present ? Qt::Unchecked : Qt::Checked);
    table_->setItem(row, kMarkColumn, mark);
    table_->setItem(row, kMarkPlaceColumn,
                    new QTableWidgetItem(QStringLiteral("%1, %2 m")
                                             .arg(words::fixed(offer.mark.at_m.x(), 2),
                                                  words::fixed(offer.mark.at_m.y(), 2))));
    table_->setItem(
        row, kMarkStateColumn,
        new QTableWidgetItem(offer.present
                                 ? tr("there already, %1 m away: moves it").arg(words::fixed(offer.away_m, 2))
                                 : tr("new")));
  }
  auto* const about = wrappedLabel(
      table_->rowCount() == 0
          ? tr("There is nothing new: what the robot has collected is in the overlays already, in its place.")
          : tr("Robots find their place by these once they are in the overlays. Nothing is sent before you "
               "save."),
      this);
  auto* const column = columnOf({about, {table_, 1}}, 8);
  if (!note.isEmpty()) column->addWidget(wrappedLabel(note, this));
  column->addLayout(rowOf({LayoutItem::rest(), cancel_, take_}, 8));
  setLayout(column);
  giveRoles(*take_, {cancel_});
  connect(table_, &QTableWidget::itemChanged, this, &OverlayMarksDialog::refresh);
  connect(take_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel_, &QPushButton::clicked, this, &QDialog::reject);
  refresh();
  resize(600, 400);
}

std::vector<overlays::MarkOffer> OverlayMarksDialog::chosen() const {
  std::vector<overlays::MarkOffer> chosen;
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->item(row, kMarkColumn)->checkState() == Qt::Checked)
      chosen.push_back(offers_[std::size_t(row)]);
  }
  return chosen;
}

void OverlayMarksDialog::refresh() {
  const auto count = qsizetype(chosen().size());
  take_->setText(
      count == 0 ? tr("Take over")
                 : sentences::counted(tr("Take over %1 marks", nullptr, sentences::formOf(count)), count));
  take_->setEnabled(count > 0);
}

}  // namespace mapwright::ui

#include "moc_overlay_marks_dialog.cpp"
