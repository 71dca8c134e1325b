#include "ui/picture/copies_dialog.h"

#include <array>
#include <utility>

#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>

#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr int kLongestName = 120;

}  // namespace

CopiesDialog::CopiesDialog(const QString& folder,
                           std::function<QString(const edit::PictureCopy&)> unavailable_reason,
                           QWidget* parent)
    : QDialog(parent),
      folder_(folder),
      unavailable_reason_(std::move(unavailable_reason)),
      about_(wrappedLabel({}, this)),
      status_(wrappedLabel({}, this)),
      table_(new QTableWidget(0, 4, this)),
      put_back_(new QPushButton(tr("&Put back…"), this)),
      open_(new QPushButton(tr("&Open"), this)),
      show_(new QPushButton(tr("Show in &folder"), this)) {
  setObjectName(QStringLiteral("pictureCopies"));
  setWindowTitle(tr("Copies of overwritten maps"));
  resize(720, 380);
  about_->setText(
      tr("Before a robot's map is overwritten, its old picture is kept in %1: the newest %2 of each "
         "map, and at most %3 in all.")
          .arg(QDir::toNativeSeparators(folder_), QString::number(edit::kMostCopies),
               bytesText(edit::kMostCopyBytes)));
  setTextColor(*about_, appColors().secondary_text);
  table_->setHorizontalHeaderLabels({tr("Overwritten"), tr("Map"), tr("Robot"), tr("Size")});
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  for (const int column : {1, 2})
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
  const auto wide = [&](const QString& sample) { return fontMetrics().horizontalAdvance(sample) + 24; };
  table_->horizontalHeader()->resizeSection(0, wide(QStringLiteral("2026-12-24 12:34:56")));
  table_->horizontalHeader()->resizeSection(
      3, wide(tr("%1 x %2 cells, %3").arg(20'000).arg(20'000).arg(bytesText(400'000'000))));
  table_->verticalHeader()->hide();
  table_->setItemDelegate(new TableRowDelegate(table_));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setAccessibleName(tr("Copies of overwritten maps"));
  put_back_->setToolTip(
      tr("Show it as an unsaved change of the map on screen, to look at before it is sent"));
  open_->setToolTip(tr("Open it as a local map"));
  auto* const close = new QPushButton(tr("&Close"), this);
  giveRoles(*put_back_, {open_, show_, close});
  setLayout(
      columnOf({about_, {table_, 1}, status_, rowOf({show_, open_, LayoutItem::rest(), close, put_back_}, 8)},
               12, QMargins(16, 16, 16, 16)));
  connect(table_, &QTableWidget::itemSelectionChanged, this, &CopiesDialog::refresh);
  connect(put_back_, &QPushButton::clicked, this, [this] {
    if (const edit::PictureCopy* const copy = chosen()) Q_EMIT putBackWanted(edit::PictureCopy(*copy));
  });
  connect(open_, &QPushButton::clicked, this, [this] {
    if (const edit::PictureCopy* const copy = chosen()) Q_EMIT openWanted(QString(copy->path));
  });
  connect(show_, &QPushButton::clicked, this, [this] {
    const edit::PictureCopy* const copy = chosen();
    Q_EMIT folderWanted(copy ? copy->folder() : folder_);
  });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  refresh();
}

void CopiesDialog::list(std::vector<edit::PictureCopy> copies) {
  copies_ = std::move(copies);
  table_->setRowCount(int(copies_->size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const edit::PictureCopy& copy = (*copies_)[std::size_t(row)];
    const QLocale c = QLocale::c();
    const QString size =
        copy.width > 0 ? tr("%1 x %2 cells, %3")
                             .arg(c.toString(copy.width), c.toString(copy.height), bytesText(copy.bytes))
                       : tr("unreadable");
    const std::array<QString, 4> texts{
        copy.made.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
        plainWords(copy.map.toStdString(), kLongestName),
        plainWords((copy.called.isEmpty() ? copy.robot : copy.called).toStdString(), kLongestName), size};
    for (int column = 0; column < int(texts.size()); ++column) {
      auto* const item = new QTableWidgetItem(texts[std::size_t(column)]);
      item->setToolTip(plainToolTip(item->text()));
      table_->setItem(row, column, item);
    }
  }
  if (table_->rowCount() > 0) table_->selectRow(0);
  refresh();
}

const edit::PictureCopy* CopiesDialog::chosen() const {
  const QList<QTableWidgetSelectionRange> ranges = table_->selectedRanges();
  return !copies_ || ranges.isEmpty() ? nullptr : &(*copies_)[std::size_t(ranges.front().topRow())];
}

void CopiesDialog::refresh() {
  const edit::PictureCopy* const copy = chosen();
  const QString why = !copies_           ? tr("Looking for copies…")
                      : copies_->empty() ? tr("There are none yet.")
                      : !copy            ? QString()
                      : copy->width == 0 ? tr("This copy cannot be read.")
                                         : unavailable_reason_(*copy);
  status_->setText(why);
  open_->setEnabled(copy && copy->width > 0);
  show_->setEnabled(copies_ && !copies_->empty());
  put_back_->setEnabled(copy && why.isEmpty());
}

QString CopiesDialog::statusShown() const { return status_->text(); }

}  // namespace mapwright::ui

#include "moc_copies_dialog.cpp"
