#include "ui/objects/properties_dock.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTableView>

#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/tree_view.h"
#include "ui/objects/object_facts.h"
#include "ui/scene/map_scene.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

constexpr int kSymbolPx = 20, kNameLetters = 18, kLeastNameLetters = 8;

QStandardItem* cell(const QString& text) {
  auto* const item = new QStandardItem(text);
  item->setEditable(false);
  item->setToolTip(plainToolTip(text));
  return item;
}

}  // namespace

PropertiesDock::PropertiesDock(const scene::MapScene& scene, QWidget* parent)
    : QDockWidget(tr("Properties"), parent),
      scene_(scene),
      symbol_(new QLabel(this)),
      title_(new PlainLabel(this)),
      state_(new PlainLabel(this)),
      model_(new QStandardItemModel(0, 2, this)),
      table_(new QuietTableView(this)),
      copy_(compactButton(tr("Copy all"), this)),
      locate_(compactButton(tr("Show on the map"), this)) {
  setObjectName(QStringLiteral("properties"));
  model_->setHorizontalHeaderLabels({tr("Property"), tr("Value")});
  showRows(*table_, model_, tr("Properties"));
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->resizeSection(0, kNameLetters * fontMetrics().averageCharWidth());
  columns_ = new NameColumn(table_, table_->horizontalHeader(), 1,
                            {{0, kLeastNameLetters * fontMetrics().averageCharWidth()}});
  table_->installEventFilter(this);
  symbol_->setFixedSize(kSymbolPx, kSymbolPx);
  makeHeading(*title_);
  state_->setSecondary(true);
  state_->setMostLines(2);
  copy_->setIcon(themedIcon(QStringLiteral("copy")));
  locate_->setIcon(themedIcon(QStringLiteral("locate")));
  auto* const body = new QWidget(this);
  body->setLayout(columnOf({rowOf({symbol_, {title_, 1}}, 8, QMargins(8, 6, 8, 0)),
                            rowOf({{state_, 1}}, 0, QMargins(8, 0, 8, 0)),
                            {table_, 1},
                            rowOf({locate_, copy_, LayoutItem::rest()}, 8, QMargins(8, 4, 8, 4))},
                           4, QMargins()));
  setWidget(body);
  connect(copy_, &QPushButton::clicked, this, [this] {
    if (object_) Q_EMIT copyWanted(asText(*object_, facts_), tr("Properties copied"));
  });
  connect(locate_, &QPushButton::clicked, this, &PropertiesDock::locateWanted);
  clear();
}

PropertiesDock::~PropertiesDock() { table_->removeEventFilter(this); }

void PropertiesDock::clear() {
  object_.reset();
  facts_.clear();
  model_->setRowCount(0);
  symbol_->hide();
  title_->setText(tr("Nothing is selected"));
  state_->setText(tr("Click something on the map, or choose it in Objects."));
  state_->show();
  copy_->setEnabled(false);
  locate_->setEnabled(false);
}

void PropertiesDock::setObject(const scene::MapObject& object,
                               const std::vector<scene::ObjectProperty>& facts, bool gone) {
  object_ = object;
  symbol_->setPixmap(QPixmap::fromImage(scene_.symbolOf(object, kSymbolPx, devicePixelRatioF())));
  symbol_->show();
  title_->setText(calledInFull(object));
  state_->setVisible(gone);
  state_->setText(tr("It is no longer on the map. Last known:"));
  copy_->setEnabled(true);
  locate_->setEnabled(true);
  // Rows keep their positions, so that a selection and the scroll bar stay.
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const int row = int(i);
    if (row >= model_->rowCount()) {
      model_->appendRow({cell(facts[i].name), cell(facts[i].value)});
    } else if (!(i < facts_.size() && facts_[i] == facts[i])) {
      model_->item(row, 0)->setText(facts[i].name);
      model_->item(row, 1)->setText(facts[i].value);
      model_->item(row, 1)->setToolTip(plainToolTip(facts[i].value));
    }
  }
  const bool other = model_->rowCount() != int(facts.size());
  model_->setRowCount(int(facts.size()));
  facts_ = facts;
  if (other) columns_->fit();
}

void PropertiesDock::copySelected() {
  QStringList lines;
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (table_->selectionModel()->isRowSelected(row))
      lines << words::about(facts_[std::size_t(row)].name, facts_[std::size_t(row)].value);
  }
  if (!lines.isEmpty()) Q_EMIT copyWanted(lines.join(QLatin1Char('\n')), tr("Properties copied"));
}

bool PropertiesDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    copySelected();
    return true;
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_properties_dock.cpp"
