#include "ui/objects/objects_dock.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QTableView>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/sorted_rows.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/objects/objects_model.h"

namespace mapwright::ui {

namespace {

constexpr int kColumnLetters = 15;

class ObjectFilter : public SortedRows {
 public:
  using SortedRows::SortedRows;

 private:
  SortValue sortValue(const QModelIndex& source) const override { return {.name = source.data().toString()}; }
};

}  // namespace

ObjectsDock::ObjectsDock(const scene::MapScene& scene, QWidget* parent)
    : QDockWidget(tr("Objects"), parent),
      model_(new ObjectsModel(scene, this)),
      filtered_(new ObjectFilter(this)),
      filter_(new QLineEdit(this)),
      table_(new QuietTableView(this)),
      count_(new PlainLabel(this)) {
  setObjectName(QStringLiteral("objects"));
  filtered_->setSourceModel(model_);
  filtered_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filtered_->setFilterKeyColumn(-1);
  filter_->setPlaceholderText(tr("Search by name, kind or layer"));
  filter_->setAccessibleName(tr("Search objects"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  showRows(*table_, filtered_, tr("Objects"));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(ObjectsModel::NameColumn, Qt::AscendingOrder);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  const int letters_px = kColumnLetters * fontMetrics().averageCharWidth();
  for (const int column : {ObjectsModel::KindColumn, ObjectsModel::LayerColumn})
    header->resizeSection(column, letters_px);
  columns_ = new NameColumn(table_, header, ObjectsModel::NameColumn,
                            {{ObjectsModel::LayerColumn}, {ObjectsModel::KindColumn, letters_px / 2}});
  table_->installEventFilter(this);
  filter_->installEventFilter(this);
  count_->setSecondary(true);
  auto* const body = new QWidget(this);
  body->setLayout(columnOf({rowOf({{filter_, 1}}, 0, QMargins(8, 6, 8, 0)),
                            {table_, 1},
                            rowOf({{count_, 1}}, 0, QMargins(8, 0, 8, 4))},
                           4, QMargins()));
  setWidget(body);
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filtered_->setFilterFixedString(text.trimmed());
    count();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& row) {
            if (!pointing_ && row.isValid())
              Q_EMIT chosen(model_->object(filtered_->mapToSource(row).row()).id);
          });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& row) {
    Q_EMIT locateWanted(model_->object(filtered_->mapToSource(row).row()).id);
  });
  count();
}

ObjectsDock::~ObjectsDock() {
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
}

void ObjectsDock::setObjects(std::vector<scene::MapObject> objects, bool more) {
  const QModelIndex current = filtered_->mapToSource(table_->currentIndex());
  const auto id = current.isValid() ? std::optional(model_->object(current.row()).id) : std::nullopt;
  {
    const QScopedValueRollback quiet(pointing_, true);
    model_->setObjects(std::move(objects));
  }
  more_ = more;
  columns_->fit();
  point(id);
  count();
}

void ObjectsDock::point(const std::optional<scene::ObjectId>& id) {
  const QScopedValueRollback quiet(pointing_, true);
  const int row = id ? model_->rowOf(*id) : -1;
  const QModelIndex index = row < 0 ? QModelIndex() : filtered_->mapFromSource(model_->index(row, 0));
  if (!index.isValid()) return table_->clearSelection();
  if (table_->currentIndex().row() != index.row() || !table_->selectionModel()->isRowSelected(index.row()))
    table_->setCurrentIndex(index);
}

void ObjectsDock::count() {
  const int all = model_->rowCount(), found = filtered_->rowCount();
  QString text = all == 0       ? tr("The visible layers show nothing here.")
                 : found == all ? sentences::counted(tr("%1 objects", nullptr, all), all)
                                : tr("%1 of %2 objects").arg(countText(found), countText(all));
  if (more_) text += tr("; more are on the map than are listed here");
  count_->setText(text);
}

void ObjectsDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  Q_EMIT shown();
}

bool ObjectsDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == filter_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    // From the search to what was found.
    if (key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter) {
      table_->setFocus();
      if (filtered_->rowCount() > 0) table_->setCurrentIndex(filtered_->index(0, 0));
      if (key != Qt::Key_Down && table_->currentIndex().isValid())
        Q_EMIT locateWanted(model_->object(filtered_->mapToSource(table_->currentIndex()).row()).id);
      return true;
    }
  }
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && table_->currentIndex().isValid()) {
      Q_EMIT locateWanted(model_->object(filtered_->mapToSource(table_->currentIndex()).row()).id);
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_objects_dock.cpp"
